#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/recordings/cut.h"

namespace haptics::recordings {
namespace parametric_cut_test {

TEST(ParametricCut, PassesThroughItsLandmarks) {
  const ForceCurve curve = parametricCut().curve;
  EXPECT_NEAR(curve.forceAt(2.0), 0.0, 1e-12);
  EXPECT_NEAR(curve.forceAt(3.8), 0.0, 1e-12);
  EXPECT_NEAR(curve.forceAt(7.2), 4.4, 1e-12);
  EXPECT_NEAR(curve.forceAt(10.3), 3.2, 1e-12);
  EXPECT_NEAR(curve.forceAt(11.0), 5.0, 1e-12);
}

TEST(ParametricCut, IsFineAndGentleEnoughToBeFelt) {
  const ForceCurve curve = parametricCut().curve;
  EXPECT_GE(curve.nodes().size(), 60U);
  EXPECT_LE(curve.largestSlope(), 4.39);
  for (const CurvePoint& node : curve.nodes()) EXPECT_GE(node.force, 0.0);
}

TEST(ParametricCut, RisesFallsAndRisesAgainBetweenItsLandmarks) {
  const std::vector<CurvePoint> nodes = parametricCut().curve.nodes();
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const double middle = (nodes[i].travel + nodes[i - 1].travel) / 2.0;
    const double rise = nodes[i].force - nodes[i - 1].force;
    if (middle < 3.8) {
      EXPECT_NEAR(rise, 0.0, 1e-12) << middle;
    } else if (middle > 7.2 && middle < 10.3) {
      EXPECT_LT(rise, 0.0) << middle;
    } else {
      EXPECT_GT(rise, 0.0) << middle;
    }
  }
}

TEST(ParametricCut, IsSmoothUpToItsEnd) {
  const std::vector<CurvePoint> nodes = parametricCut().curve.nodes();
  const auto slope = [&](std::size_t i) {
    return (nodes[i].force - nodes[i - 1].force) / (nodes[i].travel - nodes[i - 1].travel);
  };
  for (std::size_t i = 2; i < nodes.size(); ++i) {
    EXPECT_NEAR(slope(i), slope(i - 1), 1.0) << nodes[i].travel;
  }
}

TEST(ParametricCut, HasALandmarkForEachPointThatADetectorFindsToo) {
  const Cut cut = parametricCut();
  std::vector<double> travel;
  std::vector<double> force;
  for (const CurvePoint& node : cut.curve.nodes()) {
    travel.push_back(node.travel);
    force.push_back(node.force);
  }
  const CutLandmarks found = landmarksAlong(travel, force);
  ASSERT_TRUE(found.interception && found.yield && found.bottomOut);
  EXPECT_NEAR(found.interception->travel, cut.landmarks.interception->travel, 0.3);
  EXPECT_NEAR(found.yield->travel, cut.landmarks.yield->travel, 1e-9);
  EXPECT_NEAR(found.bottomOut->travel, cut.landmarks.bottomOut->travel, 1e-9);
}

TEST(ParametricCut, IsMarkedAsSynthetic) {
  const Cut cut = parametricCut();
  EXPECT_TRUE(cut.isSynthetic);
  EXPECT_EQ(cut.provenance.statement, "parametric; not a recording");
  EXPECT_TRUE(cut.provenance.sourceFile.empty());
  EXPECT_TRUE(cut.provenance.rows.empty());
  EXPECT_TRUE(cut.provenance.changes.empty());
}

TEST(ParametricCut, LimitsTheSlopeOfAShapeThatIsTooSteep) {
  const Cut cut = parametricCut({.end = {10.5, 9.0}});
  EXPECT_LE(cut.curve.largestSlope(), 4.39 + 1e-9);
  EXPECT_EQ(cut.provenance.changes.size(), 1U);
}

TEST(ParametricCut, FallsToNothingOverItsRelease) {
  const ForceCurve curve = parametricCut({.release = 1.5}).curve;
  EXPECT_EQ(curve.end(), 12.5);
  EXPECT_EQ(curve.forceAt(12.5), 0.0);
  EXPECT_NEAR(curve.forceAt(11.75), 2.5, 1e-12);  // half way from 5 N
  EXPECT_LE(curve.largestSlope(), 4.39);
}

TEST(ParametricCut, IsTheSameUpToItsEndWithARelease) {
  const ForceCurve without = parametricCut().curve;
  const ForceCurve with = parametricCut({.release = 1.5}).curve;
  ASSERT_EQ(with.nodes().size(), without.nodes().size() + 1);
  for (std::size_t i = 0; i < without.nodes().size(); ++i) {
    EXPECT_EQ(with.nodes()[i].travel, without.nodes()[i].travel);
    EXPECT_EQ(with.nodes()[i].force, without.nodes()[i].force);
  }
}

TEST(ParametricCut, RefusesAShapeThatIsNoCut) {
  EXPECT_THROW(parametricCut({.start = 4.0}), std::invalid_argument);
  EXPECT_THROW(parametricCut({.yield = {7.2, 0.0}}), std::invalid_argument);
  EXPECT_THROW(parametricCut({.yield = {3.0, 4.4}}), std::invalid_argument);
  EXPECT_THROW(parametricCut({.through = {8.4, 4.5}}), std::invalid_argument);
  EXPECT_THROW(parametricCut({.through = {8.4, 4.3}}), std::invalid_argument);
  EXPECT_THROW(parametricCut({.bottomOut = {10.3, -1.0}}), std::invalid_argument);
  EXPECT_THROW(parametricCut({.end = {11.0, 3.0}}), std::invalid_argument);
  EXPECT_THROW(parametricCut({.end = {std::nan(""), 5.0}}), std::invalid_argument);
  EXPECT_THROW(parametricCut({.spacing = 0.0}), std::invalid_argument);
  EXPECT_THROW(parametricCut({.spacing = 2.0}), std::invalid_argument);
  EXPECT_THROW(parametricCut({.release = -1.0}), std::invalid_argument);
  EXPECT_THROW(parametricCut({.maxSlope = 0.0}), std::invalid_argument);
}

}  // namespace parametric_cut_test
}  // namespace haptics::recordings
