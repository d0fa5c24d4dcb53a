// A recorded cut that ends with a force drops at once under some policies.
#include <vector>

#include <gtest/gtest.h>

#include "haptics/engine/scene_spec.h"

namespace haptics::engine {
namespace force_jumps_test {

using models::Extrapolation;

/// A cut from no force at 2 to @p end at 11 [travel units, N].
InterpolationSpec cut(Extrapolation beyond, double end) {
  InterpolationSpec spec{.curve = {{2.0, 0.0}, {7.0, 4.0}, {11.0, end}}};
  spec.options.extrapolation = beyond;
  return spec;
}

TEST(ForceJumps, AreThereWhereTheAuthorsClampOrZeroFollowsAForce) {
  const auto clamped = jumpsOf(cut(Extrapolation::AuthorsClamp, 5.0));
  ASSERT_EQ(clamped.size(), 1U);
  EXPECT_EQ(clamped[0].travel, 11.0);
  EXPECT_EQ(clamped[0].from, 4.29);
  EXPECT_EQ(clamped[0].to, 0.01);
  const auto zero = jumpsOf(cut(Extrapolation::Zero, 5.0));
  ASSERT_EQ(zero.size(), 1U);
  EXPECT_EQ(zero[0].from, 5.0);
  EXPECT_EQ(zero[0].to, 0.0);
}

TEST(ForceJumps, AreNotThereWhereTheForceFadesStaysOrIsUnknown) {
  for (const auto beyond : {Extrapolation::RampOut, Extrapolation::Hold, Extrapolation::Absent}) {
    EXPECT_TRUE(jumpsOf(cut(beyond, 5.0)).empty());
  }
}

TEST(ForceJumps, AreNotThereWhereTheCutEndsWithoutAForce) {
  for (const auto beyond : {Extrapolation::AuthorsClamp, Extrapolation::Zero}) {
    EXPECT_TRUE(jumpsOf(cut(beyond, 0.0)).empty());
  }
}

TEST(ForceJumps, OfAFilterAreThoseOfItsCut) {
  EXPECT_EQ(jumpsOf(KalmanSpec{.interpolation = cut(Extrapolation::Zero, 5.0)}).size(), 1U);
  EXPECT_TRUE(jumpsOf(FiniteElementsSpec{}).empty());
}

TEST(ForceJumps, OfAnOpeningBranchCountOnlyWhereItIsFelt) {
  auto spec = cut(Extrapolation::Zero, 0.0);
  spec.opening = {{2.0, 0.0}, {11.0, 1.0}};
  EXPECT_TRUE(jumpsOf(spec).empty());
  spec.branches = Branches::Hysteresis;
  EXPECT_EQ(jumpsOf(spec).size(), 1U);
}

TEST(ForceJumps, AreThereWhereAMaterialThatIsNotRemovedBeginsWithAForce) {
  MaterialSpec spec{.nodes = {{0.001, 50.0, 50.0}, {0.01, 60.0, 60.0}}, .forceScale = 0.5};
  const auto jumps = jumpsOf(spec);
  ASSERT_EQ(jumps.size(), 1U);
  EXPECT_EQ(jumps[0].travel, 0.001);
  EXPECT_EQ(jumps[0].from, 0.0);
  EXPECT_EQ(jumps[0].to, 25.0);
  spec.isRemoved = true;
  EXPECT_TRUE(jumpsOf(spec).empty()) << "the tool meets it through a spring";
  EXPECT_TRUE(jumpsOf(MaterialSpec{.nodes = {{0.001, 0.0, 0.0}, {0.01, 60.0, 60.0}}}).empty());
}

}  // namespace force_jumps_test
}  // namespace haptics::engine
