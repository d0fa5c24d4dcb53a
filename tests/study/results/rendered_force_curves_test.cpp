// How much the force of two alternatives differed at the handle.
#include "study/results/rendered_force_curves.h"

#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

namespace study {
namespace rendered_force_curves_test {

using Medians = std::map<int, double>;

/// A curve with these medians over all strokes, and of each participant.
RenderedForceCurve curve(
    const std::string& condition,
    const Medians& ofAll,
    const std::map<std::string, Medians>& byParticipant) {
  RenderedForceCurve made{.condition = condition, .device = "punch", .medians = byParticipant};
  for (const auto& [bin, force] : ofAll) {
    made.points.push_back({.travel = 0.5 + bin, .median = force, .bin = bin});
  }
  return made;
}

TEST(RenderedForceDifferences, CompareBothColumnsOverTheTravelThatEveryParticipantPassed) {
  const auto found = renderedForceDifferences(
      {curve(
           "a",
           {{0, 1.0}, {1, 1.0}, {2, 1.0}},
           {{"P1", {{0, 1.0}, {1, 1.0}, {2, 1.0}}}, {"P2", {{0, 1.0}}}}),
       curve(
           "b",
           {{0, 2.0}, {1, 5.0}, {2, 9.0}},
           {{"P1", {{0, 2.0}, {1, 5.0}, {2, 9.0}}}, {"P2", {{0, 2.0}, {1, 7.0}}}})});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().participants, 2U);
  EXPECT_DOUBLE_EQ(found.front().pooled, 1.0);
  EXPECT_DOUBLE_EQ(found.front().mean.value(), 1.0);
}

TEST(RenderedForceDifferences, AreNotNarrowedByParticipantsWhoPassedNothingWithBoth) {
  const auto found = renderedForceDifferences(
      {curve(
           "a",
           {{0, 1.0}, {1, 1.0}},
           {{"P1", {{0, 1.0}, {1, 1.0}}}, {"P2", {{0, 1.0}}}, {"P3", {{0, 1.0}}}}),
       curve("b", {{0, 4.0}, {1, 5.0}}, {{"P1", {{0, 4.0}, {1, 5.0}}}, {"P2", {{1, 5.0}}}})});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().participants, 1U);
  EXPECT_DOUBLE_EQ(found.front().pooled, std::sqrt((9.0 + 16.0) / 2.0));
  EXPECT_DOUBLE_EQ(found.front().mean.value(), found.front().pooled);
  EXPECT_FALSE(found.front().interval);
}

TEST(RenderedForceDifferences, NeedNoParticipantWhoFeltBoth) {
  const auto found = renderedForceDifferences(
      {curve("a", {{0, 1.0}, {1, 1.0}}, {{"P1", {{0, 1.0}, {1, 1.0}}}}),
       curve("b", {{1, 3.0}, {2, 3.0}}, {{"P2", {{1, 3.0}, {2, 3.0}}}})});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().participants, 0U);
  EXPECT_DOUBLE_EQ(found.front().pooled, 2.0);
  EXPECT_FALSE(found.front().mean);
}

}  // namespace rendered_force_curves_test
}  // namespace study
