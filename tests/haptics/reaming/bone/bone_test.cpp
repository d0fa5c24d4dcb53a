#include "haptics/reaming/bone/bone.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "haptics/reaming/bone/sphere_field.h"
#include "haptics/reaming/packing/packing_builder.h"
#include "haptics/reaming/packing/solids.h"
#include "tests/support/allocation_counter.h"

namespace haptics::reaming {
namespace bone_test {

constexpr double kTick = 0.001;
constexpr double kDensity = 1e5;

const Packing& cup() {
  static const Packing packing = *pack(Acetabulum(), {.count = 6000});
  return packing;
}

std::vector<double> alike(double density = kDensity) {
  return std::vector<double>(cup().spheres.size(), density);
}

BoneOptions options() {
  return {.coverage = cup().coverage()};
}

/// A bone, and a device that goes where it is told at a feed [m/s].
struct Experiment {
  explicit Experiment(const BoneOptions& with = options(), double density = kDensity)
      : bone(cup(), alike(density), with), plunge(plungePathInto(bone.field(), 0.026)) {
    while (!bone.step(plunge.at(depth), kTick).isDefined) {
    }
  }

  Bone::StepForce to(double wanted, double feed) {
    Bone::StepForce felt;
    const double step = feed * kTick;
    while (std::abs(wanted - depth) > 0.5 * step) {
      depth += wanted > depth ? step : -step;
      felt = bone.step(plunge.at(depth), kTick);
      largestStep = std::max(largestStep, length(felt.force - last));
      last = felt.force;
    }
    return felt;
  }
  double toolDepth() const { return bone.tool().centre.z - plunge.start; }

  Bone bone;
  PlungePath plunge;
  double depth = -0.0005;
  Vec3 last;
  double largestStep = 0.0;
};

TEST(Bone, GivesWayAtWhatAnIntactBoneOfThatDepthWouldPlusTheDampingOfTheFeed) {
  Experiment e;
  const SphereField intact(cup(), alike());
  for (const double depth : {0.003, 0.005, 0.007}) {
    const double feed = 0.002;
    e.to(depth, feed);
    const auto felt = e.to(depth + 0.001, feed);
    const auto whole = intact.touch(e.bone.tool(), false);
    const double wanted = -whole.force.z / cup().coverage();
    // What the feed adds: cutting damping times the speed of the tool, which is at most the feed.
    EXPECT_GE(-felt.force.z, 0.98 * wanted) << depth;
    EXPECT_LE(-felt.force.z, 1.02 * wanted + options().cuttingDamping * feed) << depth;
  }
}

TEST(Bone, IsNotThereAnyMoreWhereTheReamerHasBeen) {
  Experiment e;
  e.to(0.006, 0.005);
  const double hole = e.toolDepth();
  ASSERT_GT(hole, 0.003);
  e.to(-0.0005, 0.005);
  // On the way back in nothing is felt until close to the bottom of the hole.
  const auto felt = e.to(hole - 0.0004, 0.005);
  EXPECT_LT(length(felt.force), 4.0);
  const auto bottom = e.to(hole + 0.001, 0.005);
  EXPECT_GT(length(bottom.force), 15.0);
}

TEST(Bone, LosesNothingThatIsNotCounted) {
  Experiment e;
  const double whole = e.bone.remainingMass();
  double expected = 0.0;
  for (const auto& s : cup().spheres) {
    expected += kDensity * 4.0 / 3.0 * std::numbers::pi * std::pow(double{s.radius}, 3.0);
  }
  EXPECT_NEAR(whole, expected, 1e-6 * expected);
  double before = 0.0;
  for (const double depth :
       {0.004, 0.001, 0.005, 0.0, 0.007}) {  // in and out: cut, left, cut again
    e.to(depth, 0.01);
    const double removed = e.bone.removedMass();
    EXPECT_GE(removed, before);
    before = removed;
    ASSERT_NEAR(e.bone.remainingMass() + removed, whole, 1e-6 * whole) << depth;
  }
  EXPECT_GT(before, 0.003 * whole);
}

TEST(Bone, SplitsWithoutAStepInTheForce) {
  // Out by half a millimetre and in again, over and over: every remainder is made on the way.
  Experiment e;
  e.to(0.006, 0.005);
  const double force = length(e.last);
  const std::size_t filled = [&] {
    std::size_t count = 0;
    for (const auto& group : e.bone.field().groups()) {
      for (const float r : group.radius) count += r > 0.0F ? 1U : 0U;
    }
    return count;
  }();
  e.largestStep = 0.0;
  std::size_t changes = 0;
  for (int i = 0; i < 3; ++i) {
    // The device's own motion changes the coupling by K · feed · dt in a tick; the rest is bone.
    for (const double depth : {0.0, 0.006}) {
      const double feed = 0.002;
      const double step = feed * kTick;
      while (std::abs(depth - e.depth) > 0.5 * step) {
        e.depth += depth > e.depth ? step : -step;
        const auto felt = e.bone.step(e.plunge.at(e.depth), kTick);
        changes += e.bone.changed().size();
        const double own = options().coupling * step;
        ASSERT_LE(length(felt.force - e.last), own + 0.005 * force) << e.depth;
        e.last = felt.force;
      }
    }
  }
  EXPECT_GT(changes, 100U);
  std::size_t left = 0;
  for (const auto& group : e.bone.field().groups()) {
    for (const float r : group.radius) left += r > 0.0F ? 1U : 0U;
  }
  EXPECT_GT(left, filled);
}

TEST(Bone, HoldsTheToolWhenItsTeethStandStill) {
  auto still = options();
  still.isSpinning = false;
  Experiment e(still);
  const auto felt = e.to(0.008, 0.01);
  EXPECT_LT(e.toolDepth(), 0.0005);
  EXPECT_NEAR(-felt.force.z, still.coupling * (e.depth - e.toolDepth()), 1e-6);
  EXPECT_EQ(e.bone.removedMass(), 0.0);
}

TEST(Bone, NeverPullsAHand) {
  auto guided = options();
  guided.isGuided = true;
  Experiment e(guided);
  e.to(0.006, 0.005);
  while (e.depth > -0.005) {  // out, faster than the tool can follow
    e.depth -= 0.0005;
    const auto felt = e.bone.step(e.plunge.at(e.depth), kTick);
    ASSERT_LE(felt.force.z, 1e-12) << e.depth;
  }
}

TEST(Bone, RubsOnAReamerThatTurns) {
  Experiment e;
  const auto felt = e.to(0.006, 0.005);
  // Every part of the surface is at most the reamer's radius from its axis.
  const double most = options().friction * felt.contact.pressing * 0.026 / cup().coverage();
  EXPECT_LE(felt.frictionTorque, most);
  EXPECT_GT(felt.frictionTorque, 0.3 * most);
}

TEST(Bone, IsWholeAgainAfterAReset) {
  Experiment e;
  const double whole = e.bone.remainingMass();
  const auto first = e.to(0.005, 0.01);
  e.bone.reset();
  e.depth = -0.0005;
  int steps = 0;
  while (!e.bone.step(e.plunge.at(e.depth), kTick).isDefined) ASSERT_LT(++steps, 100);
  EXPECT_EQ(e.bone.remainingMass(), whole);
  EXPECT_EQ(e.bone.removedMass(), 0.0);
  const auto again = e.to(0.005, 0.01);
  EXPECT_EQ(again.force.z, first.force.z);
}

TEST(Bone, GivesNoForceToADeviceThatStartsInside) {
  Bone bone(cup(), alike(), options());
  const auto plunge = plungePathInto(bone.field(), 0.026);
  for (int i = 0; i < 200; ++i) ASSERT_FALSE(bone.step(plunge.at(0.008), kTick).isDefined);
  EXPECT_EQ(bone.removedMass(), 0.0);
  int steps = 0;
  while (!bone.step(plunge.at(-0.001), kTick).isDefined) ASSERT_LT(++steps, 100);
}

TEST(Bone, StaysSoundWithAnyMotionOfTheDevice) {
  Experiment e;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(e.bone.step({0.026, {nan, 0.0, 0.0}, {0.0, 0.0, 1.0}}, kTick).isDefined);
  EXPECT_FALSE(e.bone.step({0.026, {}, {0.0, nan, 1.0}}, kTick).isDefined);
  // Teleported 15 mm into the bone, and 50 mm through it: the tool follows no faster than it may.
  for (const double depth : {0.015, 0.05, -0.01, 0.02}) {
    for (int i = 0; i < 300; ++i) {
      const Vec3 before = e.bone.tool().centre;
      const auto felt = e.bone.step(e.plunge.at(depth), kTick);
      ASSERT_TRUE(felt.isDefined);
      ASSERT_TRUE(std::isfinite(felt.force.x + felt.force.y + felt.force.z));
      ASSERT_LE(length(e.bone.tool().centre - before), 4.0 * options().mostAdvance * 1.000001);
      ASSERT_LE(length(felt.force), options().coupling * 0.06);
    }
  }
}

TEST(Bone, StaysFiniteForDensitiesOfZeroAndOfSteel) {
  Experiment nothing(options(), 0.0);
  EXPECT_LT(length(nothing.to(0.008, 0.01).force), options().cuttingDamping * 0.0101);
  Experiment steel(options(), 1e12);
  const auto felt = steel.to(0.004, 0.01);
  EXPECT_TRUE(std::isfinite(felt.force.z));
  EXPECT_LT(steel.toolDepth(), 0.0005);
}

TEST(Bone, AllocatesNothingInAStep) {
  Experiment e;
  e.to(0.004, 0.01);
  const tests::AllocationCounter counter;
  e.to(0.006, 0.01);
  e.to(0.003, 0.01);
  e.bone.reset();
  e.bone.step(e.plunge.at(0.0), kTick);
  EXPECT_EQ(counter.count(), 0U);
}

TEST(Bone, RefusesOptionsThatMakeNoSense) {
  for (const BoneOptions& wrong :
       {BoneOptions{.coverage = 0.0},
        BoneOptions{.coupling = -1.0},
        BoneOptions{.cuttingDamping = std::nan("")},
        BoneOptions{.mostAdvance = 0.0}}) {
    EXPECT_THROW(Bone(cup(), alike(), wrong), std::invalid_argument);
  }
}

}  // namespace bone_test
}  // namespace haptics::reaming
