#include "haptics/reaming/packing/packing_builder.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "haptics/reaming/packing/solids.h"

namespace haptics::reaming {
namespace packing_builder_test {

TEST(PackingBuilder, FillsTheCupWithoutOverlap) {
  const Acetabulum cup;
  const auto packing = pack(cup, {.count = 5000});
  ASSERT_TRUE(packing);
  EXPECT_EQ(packing->spheres.size(), 5000U);
  EXPECT_GT(packing->coverage(), 0.64);  // the greedy prototype reached 0.556
  EXPECT_LT(packing->coverage(), 0.75);
  const auto flaws = flawsOf(*packing, cup);
  EXPECT_LE(flaws.overlap, 1e-9);
  EXPECT_LE(flaws.protrusion, 1e-9);
  for (std::size_t i = 1; i < packing->spheres.size(); ++i) {
    ASSERT_GE(packing->spheres[i - 1].radius, packing->spheres[i].radius);
  }
}

TEST(PackingBuilder, FindsEveryOverlapThatThereIs) {
  // The test of the test: pairs by brute force, in a packing that has been spoilt.
  const Acetabulum cup;
  auto packing = *pack(cup, {.count = 800});
  packing.spheres[17].radius *= 1.2F;
  double worst = 0.0;
  for (std::size_t i = 0; i < packing.spheres.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto& a = packing.spheres[i];
      const auto& b = packing.spheres[j];
      const double over = double{a.radius} + b.radius - length(a.centre() - b.centre());
      worst = std::max(worst, over / std::min(a.radius, b.radius));
    }
  }
  ASSERT_GT(worst, 0.01);
  EXPECT_NEAR(flawsOf(packing, cup).overlap, worst, 1e-9);
}

TEST(PackingBuilder, IsTheSameForASeedWithAnyNumberOfThreads) {
  const Acetabulum cup;
  const auto one = *pack(cup, {.count = 2000, .seed = 5, .threads = 1});
  const auto three = *pack(cup, {.count = 2000, .seed = 5, .threads = 3});
  const auto other = *pack(cup, {.count = 2000, .seed = 6, .threads = 1});
  bool isOther = false;
  for (std::size_t i = 0; i < one.spheres.size(); ++i) {
    const auto& a = one.spheres[i];
    const auto& b = three.spheres[i];
    ASSERT_TRUE(a.x == b.x && a.y == b.y && a.z == b.z && a.radius == b.radius);
    isOther |= a.x != other.spheres[i].x;
  }
  EXPECT_TRUE(isOther);
}

TEST(PackingBuilder, StopsAtACoverageOrASmallestRadius) {
  const Acetabulum cup;
  const auto half = *pack(cup, {.coverage = 0.5, .largestRadius = 0.003});
  EXPECT_NEAR(half.coverage(), 0.5, 0.001);
  const auto coarse = *pack(cup, {.smallestRadius = 0.001, .largestRadius = 0.003});
  EXPECT_GE(coarse.spheres.back().radius, 0.001F * 0.999999F);
  EXPECT_LE(coarse.spheres.front().radius, 0.003F);
}

TEST(PackingBuilder, ReportsProgressAndCanBeCancelled) {
  const Acetabulum cup;
  int told = 0;
  EXPECT_FALSE(pack(cup, {.count = 5000}, [&](const PackingProgress& progress) {
    EXPECT_GT(progress.radius, 0.0);
    return ++told < 3;
  }));
  EXPECT_EQ(told, 3);
}

TEST(PackingBuilder, RefusesInvalidOptions) {
  const Acetabulum cup;
  const PackingOptions wrong[]{
      {},
      {.count = 10, .coverage = 0.5},
      {.count = 0},
      {.coverage = 0.99},
      {.smallestRadius = 0.002, .largestRadius = 0.001},
      {.smallestRadius = std::nan("")},
      {.count = 10, .threads = 0},
      {.count = 100'000, .largestRadius = 0.02},  // there is no room for so many of that size
      {.smallestRadius = 0.01},                   // none of that size fits between its walls
      {.count = 50'000'000},
      {.count = 8'000'000, .largestRadius = 1e-6}};
  for (const auto& options : wrong) EXPECT_THROW(pack(cup, options), std::invalid_argument);
  EXPECT_THROW(Acetabulum(0.04, 0.03), std::invalid_argument);
}

TEST(Acetabulum, KnowsItsBoundary) {
  const Acetabulum cup(0.02, 0.04);
  EXPECT_NEAR(cup.volume(), 2.0 / 3.0 * std::numbers::pi * (64e-6 - 8e-6), 1e-15);
  const auto inner = cup.nearest({0.0, 0.0, 0.021});
  EXPECT_NEAR(inner.distance, 0.001, 1e-15);
  EXPECT_NEAR(inner.inward.z, 1.0, 1e-15);
  const auto rim = cup.nearest({0.03, 0.0, 0.002});
  EXPECT_NEAR(rim.distance, 0.002, 1e-15);
  EXPECT_LT(cup.nearest({0.0, 0.0, 0.01}).distance, 0.0);
  EXPECT_LT(cup.nearest({0.0, 0.0, -0.03}).distance, 0.0);
}

}  // namespace packing_builder_test
}  // namespace haptics::reaming
