#include "haptics/models/cut_detector.h"

#include <cmath>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

namespace haptics::models {
namespace cut_detector_test {

using Detector = CutDetector<double>;
using Event = Detector::Event;

struct Sample {
  double travel;
  double force;
};

/// Straight from corner to corner, in steps of about 0.05 travel units or newtons.
std::vector<Sample> path(const std::vector<Sample>& corners) {
  std::vector<Sample> samples{corners.front()};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Sample& from = corners[i - 1];
    const Sample& to = corners[i];
    const double reach =
        std::max(std::abs(to.travel - from.travel), std::abs(to.force - from.force));
    const int steps = std::max(1, static_cast<int>(std::lround(reach / 0.05)));
    for (int k = 1; k <= steps; ++k) {
      const double share = static_cast<double>(k) / steps;
      samples.push_back(
          {from.travel + (to.travel - from.travel) * share,
           from.force + (to.force - from.force) * share});
    }
  }
  return samples;
}

/// What a detector says of a path, without the silence.
std::vector<Event> eventsOf(Detector& detector, const std::vector<Sample>& samples) {
  std::vector<Event> events;
  for (const Sample& sample : samples) {
    const Event event = detector.feed(sample.travel, sample.force);
    if (event != Event::Nothing) events.push_back(event);
  }
  return events;
}

Detector::Cut cutAlong(const std::vector<Sample>& corners) {
  Detector detector;
  eventsOf(detector, path(corners));
  EXPECT_EQ(detector.completedCuts(), 1U);
  return detector.lastCut();
}

void expectAt(const Detector::Landmark& landmark, double travel, double force) {
  EXPECT_TRUE(landmark.found);
  EXPECT_NEAR(landmark.travel, travel, 0.06);
  EXPECT_NEAR(landmark.force, force, 0.06);
}

/// Touches at 4, yields at 7, bottoms out at 10.3, presses home and opens.
const std::vector<Sample> kCut{
    {0.0, 0.0},
    {4.0, 0.0},
    {7.0, 4.4},
    {10.3, 3.4},
    {10.8, 5.8},
    {10.0, 5.0},
    {9.8, 0.0},
    {0.0, 0.0}};

TEST(CutDetector, FindsTheFourPointsOfACut) {
  const Detector::Cut cut = cutAlong(kCut);

  expectAt(cut.interception, 4.0, 0.0);
  expectAt(cut.yield, 7.0, 4.4);
  expectAt(cut.bottomOut, 10.3, 3.4);
  expectAt(cut.opening, 10.8, 5.8);
  EXPECT_DOUBLE_EQ(cut.peakForce, 5.8);
  EXPECT_DOUBLE_EQ(cut.largestTravel, 10.8);
}

TEST(CutDetector, FindsThePointsOfThePrintedReferenceCut) {
  // Ten of the 76 pairs of the authors' control sketch; then the hand opens.
  const std::vector<Sample> printed{
      {2.079, 0.0},
      {3.813, 0.0},
      {3.961, 0.084},
      {4.283, 0.823},
      {5.171, 3.313},
      {6.335, 4.344},
      {7.183, 4.369},
      {9.429, 3.966},
      {10.349, 3.679},
      {10.820, 4.344},
      {9.0, 0.0},
      {2.0, 0.0}};
  Detector detector;
  for (const Sample& sample : printed) detector.feed(sample.travel, sample.force);

  const Detector::Cut& cut = detector.lastCut();
  EXPECT_EQ(cut.interception.travel, 3.813);
  EXPECT_EQ(cut.yield.travel, 7.183);
  EXPECT_EQ(cut.bottomOut.travel, 10.349);
  EXPECT_EQ(cut.opening.travel, 10.820);
}

TEST(CutDetector, ReportsEachPointOnceAndInOrder) {
  Detector detector;
  const std::vector<Event> expected{
      Event::Interception, Event::Yield, Event::BottomOut, Event::Opening, Event::CutCompleted};
  EXPECT_EQ(eventsOf(detector, path(kCut)), expected);
  EXPECT_EQ(eventsOf(detector, path(kCut)), expected);
  EXPECT_EQ(detector.completedCuts(), 2U);
}

TEST(CutDetector, ReportsTheLandmarksFoundSoFar) {
  Detector detector;
  eventsOf(detector, path({{0.0, 0.0}, {4.0, 0.0}, {7.0, 4.4}, {9.0, 3.4}}));

  EXPECT_TRUE(detector.cut().interception.found);
  EXPECT_TRUE(detector.cut().yield.found);
  EXPECT_FALSE(detector.cut().bottomOut.found);
  EXPECT_EQ(detector.completedCuts(), 0U);
}

TEST(CutDetector, CountsAHandThatTremblesAtAThresholdOnce) {
  Detector detector;
  std::vector<Sample> corners{{0.0, 0.0}};
  for (int i = 0; i < 20; ++i) {
    corners.push_back({6.8, 1.0});
    corners.push_back({7.2, 1.1});
  }
  corners.push_back({0.0, 0.0});
  eventsOf(detector, path(corners));
  EXPECT_EQ(detector.completedCuts(), 1U);
}

TEST(CutDetector, CountsNoCutThatWasNotClosed) {
  Detector detector;
  eventsOf(
      detector, path({{0.0, 0.0}, {4.0, 0.0}, {6.5, 3.0}, {0.0, 0.0}, {6.9, 3.0}, {0.0, 0.0}}));
  EXPECT_EQ(detector.completedCuts(), 0U);
  EXPECT_FALSE(detector.cut().interception.found);
}

TEST(CutDetector, CountsNoHandThatWasClosedFromTheStart) {
  const auto opened = path({{10.5, 6}, {0, 0}});
  Detector detector;
  EXPECT_TRUE(eventsOf(detector, opened).empty());
  EXPECT_EQ(detector.completedCuts(), 0U);
  eventsOf(detector, path({{0, 0}, {10.5, 6}, {0, 0}}));
  EXPECT_EQ(detector.completedCuts(), 1U) << "it is open now";
  detector.reset();
  EXPECT_TRUE(eventsOf(detector, opened).empty()) << "a new trial";
}

TEST(CutDetector, FindsNoPointsWithoutACut) {
  const Detector::Cut cut = cutAlong({{0.0, 0.0}, {10.5, 0.0}, {0.0, 0.0}});

  EXPECT_FALSE(cut.interception.found);
  EXPECT_FALSE(cut.yield.found);
  EXPECT_FALSE(cut.bottomOut.found);
  EXPECT_FALSE(cut.opening.found);
  EXPECT_EQ(cut.peakForce, 0.0);
}

TEST(CutDetector, FindsNoYieldWhenTheHandLetsGo) {
  const Detector::Cut cut =
      cutAlong({{0.0, 0.0}, {4.0, 0.0}, {10.5, 6.0}, {10.5, 1.0}, {9.0, 0.0}, {0.0, 0.0}});

  EXPECT_TRUE(cut.interception.found);
  EXPECT_FALSE(cut.yield.found);
  EXPECT_FALSE(cut.bottomOut.found);
  expectAt(cut.opening, 10.5, 6.0);
}

TEST(CutDetector, HasNoOpeningIfTheForceNeverRisesAgain) {
  const Detector::Cut cut =
      cutAlong({{0.0, 0.0}, {4.0, 0.0}, {6.0, 4.0}, {10.5, 2.0}, {9.0, 0.0}, {0.0, 0.0}});

  expectAt(cut.yield, 6.0, 4.0);
  EXPECT_FALSE(cut.bottomOut.found);
  EXPECT_FALSE(cut.opening.found);
}

TEST(CutDetector, PassesOverFrictionInTheHinge) {
  // 0.4 N per travel unit, less than the frictionSlope of 0.5.
  const Detector::Cut cut = cutAlong(
      {{0.0, 0.0}, {6.0, 2.4}, {8.0, 6.0}, {10.0, 5.0}, {10.5, 7.0}, {9.0, 0.0}, {0.0, 0.0}});
  expectAt(cut.interception, 6.0, 2.4);
}

TEST(CutDetector, StartsFromAnyBiasOfTheSensor) {
  std::vector<Sample> biased = kCut;
  for (Sample& corner : biased) corner.force += 2.66;  // N: the worst of PART_I
  const Detector::Cut cut = cutAlong(biased);

  expectAt(cut.interception, 4.0, 2.66);
  expectAt(cut.yield, 7.0, 7.06);
  expectAt(cut.bottomOut, 10.3, 6.06);
}

/// A scene that holds a force at rest, which comes on softly before the first cut only.
TEST(CutDetector, FindsTheSamePointsInEqualCutsAlsoAfterASoftStart) {
  constexpr double kAtRest = 0.46;
  std::vector<Sample> held = kCut;
  for (Sample& corner : held) corner.force += kAtRest;
  Detector detector;
  for (const Sample& sample : path({{0.0, 0.0}, {0.0, kAtRest}})) {
    EXPECT_EQ(detector.feed(sample.travel, sample.force, true), Event::Nothing);
  }
  eventsOf(detector, path(held));
  const auto first = detector.lastCut();
  eventsOf(detector, path(held));
  const auto second = detector.lastCut();
  EXPECT_EQ(detector.completedCuts(), 2U);
  expectAt(first.interception, 4.0, kAtRest);
  EXPECT_EQ(first.interception.travel, second.interception.travel);
  EXPECT_EQ(first.interception.force, second.interception.force);
  EXPECT_EQ(first.yield.travel, second.yield.travel);
  EXPECT_EQ(first.opening.force, second.opening.force);

  Detector unaware;  // takes the soft start for a contact
  eventsOf(unaware, path({{0.0, 0.0}, {0.0, kAtRest}}));
  eventsOf(unaware, path(held));
  EXPECT_LT(unaware.lastCut().interception.travel, 1.0);
}

TEST(CutDetector, ForgetsATouchWithoutACut) {
  const Detector::Cut cut = cutAlong(
      {{0.0, 0.0},
       {1.0, 0.0},
       {1.3, 1.4},
       {1.8, 0.0},
       {5.0, 0.0},
       {7.5, 4.0},
       {10.3, 3.0},
       {10.5, 5.0},
       {9.0, 0.0},
       {0.0, 0.0}});
  expectAt(cut.interception, 5.0, 0.0);
  expectAt(cut.yield, 7.5, 4.0);
}

TEST(CutDetector, KeepsTheLargerOfTwoTouchesInOneClosure) {
  const Detector::Cut cut = cutAlong(
      {{0.0, 0.0}, {9.5, 0.0}, {10.0, 3.0}, {10.0, 0.0}, {10.1, 0.0}, {10.2, 1.0}, {0.0, 0.0}});
  expectAt(cut.interception, 9.5, 0.0);
  expectAt(cut.opening, 10.0, 3.0);
}

TEST(CutDetector, RetractsAYieldIfTheForceRisesFurther) {
  Detector detector;
  const std::vector<Event> events = eventsOf(
      detector,
      path(
          {{0.0, 0.0},
           {4.0, 0.0},
           {5.5, 3.0},
           {6.3, 2.5},
           {8.0, 5.0},
           {10.2, 3.5},
           {10.5, 5.5},
           {9.0, 0.0},
           {0.0, 0.0}}));

  const std::vector<Event> expected{
      Event::Interception,
      Event::Yield,
      Event::Yield,
      Event::BottomOut,
      Event::Opening,
      Event::CutCompleted};
  EXPECT_EQ(events, expected);
  expectAt(detector.lastCut().yield, 8.0, 5.0);
}

TEST(CutDetector, MovesTheBottomOutToADeeperOneFurtherOn) {
  const Detector::Cut cut = cutAlong(
      {{0.0, 0.0},
       {4.0, 0.0},
       {7.0, 5.0},
       {9.8, 3.6},
       {10.2, 4.0},
       {10.8, 3.0},
       {11.0, 6.0},
       {0.0, 0.0}});
  expectAt(cut.bottomOut, 10.8, 3.0);
  expectAt(cut.opening, 11.0, 6.0);
}

TEST(CutDetector, FollowsAHandThatEasesAndClosesFurther) {
  const Detector::Cut cut = cutAlong(
      {{0.0, 0.0},
       {4.0, 0.0},
       {8.0, 4.0},
       {6.8, 3.0},
       {8.5, 4.5},
       {10.2, 3.2},
       {10.6, 5.5},
       {9.0, 0.0},
       {0.0, 0.0}});
  expectAt(cut.interception, 4.0, 0.0);
  expectAt(cut.yield, 8.5, 4.5);
  expectAt(cut.opening, 10.6, 5.5);
}

TEST(CutDetector, IgnoresNaN) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Detector detector;
  Detector spared;
  for (const Sample& sample : path(kCut)) {
    EXPECT_EQ(detector.feed(kNan, sample.force), Event::Nothing);
    EXPECT_EQ(detector.feed(sample.travel, kNan), Event::Nothing);
    EXPECT_EQ(detector.feed(kInfinity, -kInfinity), Event::Nothing);
    EXPECT_EQ(detector.feed(sample.travel, sample.force), spared.feed(sample.travel, sample.force));
  }
  EXPECT_EQ(detector.completedCuts(), 1U);
  EXPECT_EQ(detector.lastCut().yield.travel, spared.lastCut().yield.travel);
}

TEST(CutDetector, FindsTheSamePointsInSinglePrecision) {
  CutDetector<float> detector;
  for (const Sample& sample : path(kCut)) {
    detector.feed(static_cast<float>(sample.travel), static_cast<float>(sample.force));
  }
  const Detector::Cut cut = cutAlong(kCut);
  EXPECT_FLOAT_EQ(detector.lastCut().yield.travel, static_cast<float>(cut.yield.travel));
  EXPECT_FLOAT_EQ(detector.lastCut().bottomOut.travel, static_cast<float>(cut.bottomOut.travel));
}

TEST(CutDetector, FindsTheStrokesOfAnotherToolByItsOwnMeasures) {
  // A reamer that goes 20 mm deep: metres, and hundreds of newtons.
  Detector reamer({
      .closedAbove = 0.010,
      .openBelow = 0.002,
      .contactForce = 10.0,
      .frictionSlope = 0.0,
      .yieldDrop = 20.0,
      .yieldDropRatio = 0.1,
      .advance = 0.0005,
      .bottomOutAbove = 0.015,
      .bottomOutRise = 20.0,
      .retreat = 0.002,
  });
  std::vector<Sample> stroke =
      path({{0.0, 0.0}, {4.0, 0.0}, {12.0, 8.0}, {16.0, 6.0}, {20.0, 8.0}, {0.0, 0.0}});
  for (const Sample& sample : stroke) reamer.feed(sample.travel * 1e-3, sample.force * 100.0);

  EXPECT_EQ(reamer.completedCuts(), 1U);
  EXPECT_NEAR(reamer.lastCut().yield.travel, 0.012, 1e-4);
  EXPECT_NEAR(reamer.lastCut().bottomOut.travel, 0.016, 1e-4);
}

TEST(CutDetector, ForgetsEverythingButItsParameters) {
  Detector detector({.closedAbove = 3.0, .openBelow = 1.0});
  eventsOf(detector, path(kCut));
  detector.reset();
  EXPECT_EQ(detector.completedCuts(), 0U);
  EXPECT_FALSE(detector.lastCut().yield.found);

  eventsOf(detector, path({{0.0, 0.0}, {3.5, 0.0}, {0.0, 0.0}}));
  EXPECT_EQ(detector.completedCuts(), 1U);
}

TEST(CutDetector, RefusesUnsoundParameters) {
  EXPECT_TRUE(Detector::isSound({}));
  EXPECT_FALSE(Detector::isSound({.closedAbove = 4.0, .openBelow = 4.0}));
  EXPECT_FALSE(Detector::isSound({.contactForce = 0.0}));
  EXPECT_FALSE(Detector::isSound({.frictionSlope = -0.1}));
  EXPECT_FALSE(Detector::isSound({.yieldLoad = -0.1}));
  EXPECT_FALSE(Detector::isSound({.leastLoadAfterYield = 1.0}));
  EXPECT_FALSE(Detector::isSound({.bottomOutAbove = std::numeric_limits<double>::infinity()}));
  EXPECT_FALSE(Detector::isSound({.retreat = std::numeric_limits<double>::quiet_NaN()}));
}

TEST(CutDetector, StaysFiniteWithAnyInput) {
  std::mt19937 random(76);
  std::uniform_real_distribution<double> travel(-1e3, 1e3);
  std::uniform_real_distribution<double> force(-1e300, 1e300);
  std::uniform_int_distribution<int> kind(0, 9);
  Detector detector;
  for (int i = 0; i < 100'000; ++i) {
    const bool isWild = kind(random) == 0;
    detector.feed(isWild ? force(random) : travel(random) / 50.0, isWild ? 1e308 : force(random));
    for (const auto& cut : {detector.cut(), detector.lastCut()}) {
      for (const auto& point : {cut.interception, cut.yield, cut.bottomOut, cut.opening}) {
        ASSERT_TRUE(std::isfinite(point.travel) && std::isfinite(point.force));
      }
    }
  }
}

// It may live in a sample ring, in a tick and on a microcontroller.
static_assert(std::is_trivially_copyable_v<Detector>);
static_assert(noexcept(std::declval<Detector&>().feed(0.0, 0.0)));
static_assert(sizeof(CutDetector<float>) <= 256);

/// A blow on the handle: the finger loses it on the way, and finds it again at the end.
const std::vector<Sample> kBlow{
    {0, 0}, {4, 0}, {7, 3.7}, {9, 0.1}, {10, 0}, {10.3, 0}, {10.3, 4.5}, {9, 0}, {0, 0}};

/// A sheet of paper: little load, and half of it is left.
const std::vector<Sample> kPaper{
    {0, 0}, {6.9, 0}, {8, 2.6}, {9.1, 2.1}, {10.2, 3.2}, {9, 0}, {0, 0}};

Detector::Cut cutAlong(const std::vector<Sample>& corners, const Detector::Parameters& parameters) {
  Detector detector(parameters);
  eventsOf(detector, path(corners));
  return detector.lastCut();
}

TEST(CutDetector, FindsNoYieldThatLosesTooMuchOfItsLoad) {
  EXPECT_TRUE(cutAlong(kBlow).yield.found);
  const auto cut = cutAlong(kBlow, {.leastLoadAfterYield = 0.25});
  EXPECT_FALSE(cut.yield.found);
  EXPECT_FALSE(cut.bottomOut.found);
  EXPECT_TRUE(cut.interception.found);
}

TEST(CutDetector, FindsNoYieldBelowTheLeastLoad) {
  EXPECT_TRUE(cutAlong(kPaper).yield.found);
  const auto cut = cutAlong(kPaper, {.yieldLoad = 3.0});
  EXPECT_FALSE(cut.yield.found);
  expectAt(cut.opening, 10.2, 3.2);
}

TEST(CutDetector, KeepsAYieldWhoseLoadIsLostOnlyWhileTheHandOpens) {
  const std::vector<Sample> tissue{
      {0, 0}, {4, 0}, {7, 4.4}, {9.5, 3.2}, {10, 3.2}, {9.5, 0}, {0, 0}};
  const auto cut = cutAlong(tissue, {.yieldLoad = 3.0, .leastLoadAfterYield = 0.25});
  expectAt(cut.yield, 7.0, 4.4);
}

}  // namespace cut_detector_test
}  // namespace haptics::models
