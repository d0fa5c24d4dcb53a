#include "haptics/reaming/bone/sphere_field.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "haptics/reaming/packing/packing_builder.h"
#include "haptics/reaming/packing/solids.h"
#include "tests/support/allocation_counter.h"

namespace haptics::reaming {
namespace sphere_field_test {

constexpr double kPi = std::numbers::pi;

/// A solid block below z = 0 … the reamer comes from −z: a slab from z = 0 on.
class Slab final : public Solid {
 public:
  SurfacePoint nearest(Vec3 p) const noexcept override {
    const double all[]{p.x + kHalf, kHalf - p.x, p.y + kHalf, kHalf - p.y, p.z, kDeep - p.z};
    const Vec3 inward[]{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::size_t best = 0;
    for (std::size_t i = 1; i < 6; ++i) {
      if (all[i] < all[best]) best = i;
    }
    return {all[best], inward[best]};
  }
  Vec3 lowerCorner() const noexcept override { return {-kHalf, -kHalf, 0.0}; }
  Vec3 upperCorner() const noexcept override { return {kHalf, kHalf, kDeep}; }
  double volume() const noexcept override { return 4.0 * kHalf * kHalf * kDeep; }

  static constexpr double kHalf = 0.03;
  static constexpr double kDeep = 0.02;
};

std::vector<double> alike(const Packing& packing, double density) {
  return std::vector<double>(packing.spheres.size(), density);
}

/// In doubles, one after the other: what the field's kernel is held against.
ReamerContact bruteForce(
    const Packing& packing, const std::vector<double>& densities, const Reamer& reamer) {
  ReamerContact contact;
  for (std::size_t i = 0; i < packing.spheres.size(); ++i) {
    const auto& s = packing.spheres[i];
    const Vec3 away = s.centre() - reamer.centre;
    const double d = length(away);
    const double over = d - reamer.radius;
    const double lens = double{s.radius} * s.radius - over * over;
    if (lens <= 0.0 || dot(away, reamer.axis) < 0.0) continue;
    const double a = kPi * reamer.radius * lens / d;
    contact.area += a;
    contact.pressing += a * densities[i];
    contact.normal = contact.normal + (-a / d) * away;
    contact.force = contact.force + (-a * densities[i] / d) * away;
    const double along = dot(away, reamer.axis);
    contact.lever += a * densities[i] * std::sqrt(d * d - along * along);
    ++contact.touched;
  }
  return contact;
}

TEST(SphereField, AddsUpWhatAReamerTouches) {
  const auto packing = *pack(Acetabulum(), {.count = 8000});
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> density(0.0, 5e5);
  std::vector<double> densities;
  for (std::size_t i = 0; i < packing.spheres.size(); ++i) densities.push_back(density(random));
  const SphereField field(packing, densities);
  std::uniform_real_distribution<double> off(-0.006, 0.006);
  for (int i = 0; i < 200; ++i) {
    Vec3 axis{off(random), off(random), 0.02};
    axis = (1.0 / length(axis)) * axis;
    const Reamer reamer{0.026, {off(random), off(random), off(random)}, axis};
    const auto wanted = bruteForce(packing, densities, reamer);
    for (const bool isCut : {false, true}) {  // nothing has been cut: both say the same
      const auto found = field.touch(reamer, isCut);
      ASSERT_NEAR(found.area, wanted.area, 2e-5 * wanted.area);
      ASSERT_NEAR(found.density(), wanted.density(), 2e-5 * wanted.density());
      ASSERT_NEAR(length(found.force - wanted.force), 0.0, 3e-5 * wanted.pressing);
      ASSERT_NEAR(length(found.normal - wanted.normal), 0.0, 3e-5 * wanted.area);
      ASSERT_NEAR(found.lever, wanted.lever, 3e-5 * wanted.lever);
      ASSERT_NEAR(found.touched, wanted.touched, 3);
    }
  }
}

TEST(SphereField, OneSphereIsACapInClosedForm) {
  // A sphere r whose centre is at a distance d of the centre of a ball R takes the cap of area
  // πR (r² − (d − R)²)/d from it; half-way in, that is nearly its great circle.
  Packing packing{.spheres = {{0.0F, 0.0F, 0.026F, 0.001F}}, .volume = 1e-8};
  const SphereField field(packing, alike(packing, 2e5));
  const Reamer reamer{0.026, {}, {0.0, 0.0, 1.0}};
  const auto contact = field.touch(reamer, false);
  EXPECT_NEAR(contact.area, kPi * 1e-6, 1e-11);
  EXPECT_NEAR(contact.force.z, -2e5 * kPi * 1e-6, 1e-5);
  EXPECT_NEAR(contact.density(), 2e5, 1.0);
  const auto behind = field.touch({0.026, {}, {0.0, 0.0, -1.0}}, false);
  EXPECT_EQ(behind.touched, 0);
  EXPECT_EQ(behind.density(), 0.0);  // and not 0/0
}

TEST(SphereField, FeelsAFlatSlabAsTheCapOfABall) {
  // Area 2πRh, and force along the axis ρ·π(2Rh − h²), both over the coverage (Delesse).
  const Slab slab;
  const auto packing = *pack(slab, {.count = 40'000});
  const SphereField field(packing, alike(packing, 1e5));
  const double R = 0.026;
  for (const double h : {0.004, 0.006, 0.008}) {
    const auto contact = field.touch({R, {0.0, 0.0, h - R}, {0.0, 0.0, 1.0}}, false);
    const double area = contact.area / packing.coverage();
    EXPECT_NEAR(area / (2.0 * kPi * R * h), 1.0, 0.06) << h;
    const double force = -contact.force.z / packing.coverage();
    EXPECT_NEAR(force / (1e5 * kPi * (2.0 * R * h - h * h)), 1.0, 0.06) << h;
    const Vec3 n = (1.0 / length(contact.normal)) * contact.normal;
    EXPECT_NEAR(n.z, -1.0, 0.001);
  }
}

/// The largest departure of the area from that of the hemisphere while it goes through the bone.
double ripple(std::size_t count) {
  const auto packing = *pack(Acetabulum(0.0, 0.041), {.count = count});
  const SphereField field(packing, alike(packing, 1.0));
  std::vector<double> areas;
  for (double z = 0.002; z < 0.012; z += 0.00005) {
    areas.push_back(field.touch({0.026, {0.0, 0.0, z}, {0.0, 0.0, 1.0}}, false).area);
  }
  double mean = 0.0;
  for (const double area : areas) mean += area / static_cast<double>(areas.size());
  EXPECT_NEAR(mean / packing.coverage() / (2.0 * kPi * 0.026 * 0.026), 1.0, 0.05);
  double worst = 0.0;
  for (const double area : areas) worst = std::max(worst, std::abs(area / mean - 1.0));
  return worst;
}

TEST(SphereField, RipplesLessWithMoreSpheres) {
  const double few = ripple(5000);
  const double many = ripple(40'000);
  EXPECT_LT(few, 0.06);
  EXPECT_LT(many, 0.03);
  EXPECT_LT(many, few);
}

TEST(SphereField, GivesNoForceAtPositionsThatAreNotFiniteAndAllocatesNothing) {
  const auto packing = *pack(Acetabulum(), {.count = 2000});
  const SphereField field(packing, alike(packing, 1e5));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(field.touch({0.026, {nan, 0.0, 0.0}, {0.0, 0.0, 1.0}}, false).touched, 0);
  EXPECT_EQ(field.touch({0.026, {0.0, 0.0, 1e300}, {0.0, 0.0, 1.0}}, false).touched, 0);
  EXPECT_EQ(field.touch({0.026, {0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}}, false).touched, 0);
  const tests::AllocationCounter counter;
  const auto contact = field.touch({0.026, {0.0, 0.0, 0.003}, {0.0, 0.0, 1.0}}, true);
  EXPECT_EQ(counter.count(), 0U);
  EXPECT_GT(contact.touched, 10);
}

TEST(SphereField, RefusesWhatIsNoBone) {
  const auto packing = *pack(Acetabulum(), {.count = 100});
  EXPECT_THROW(SphereField(packing, std::vector<double>(99, 1.0)), std::invalid_argument);
  EXPECT_THROW(SphereField(packing, alike(packing, -1.0)), std::invalid_argument);
  EXPECT_THROW(SphereField(packing, alike(packing, std::nan(""))), std::invalid_argument);
  EXPECT_THROW(SphereField({}, {}), std::invalid_argument);
}

TEST(PlungePath, BeginsWhereTheReamerTouchesFirst) {
  const auto packing = *pack(Acetabulum(), {.count = 3000});
  const SphereField field(packing, alike(packing, 1.0));
  const auto plunge = plungePathInto(field, 0.026);
  EXPECT_EQ(field.touch(plunge.at(0.0), false).touched, 0);
  EXPECT_GE(field.touch(plunge.at(0.00005), false).touched, 1);
  const Packing elsewhere{.spheres = {{0.1F, 0.0F, 0.0F, 0.001F}}, .volume = 1.0};
  const SphereField aside(elsewhere, alike(elsewhere, 1.0));
  EXPECT_THROW(plungePathInto(aside, 0.026), std::invalid_argument);
}

}  // namespace sphere_field_test
}  // namespace haptics::reaming
