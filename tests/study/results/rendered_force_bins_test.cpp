// The samples of a trial that count as force while the tool advanced.
#include "study/results/rendered_force_bins.h"

#include <vector>

#include <gtest/gtest.h>

#include "haptics/devices/iiwa/reamer_kind.h"
#include "haptics/devices/punch/punch_kind.h"
#include "haptics/engine/built_in_models.h"

namespace study {
namespace rendered_force_bins_test {

using haptics::devices::punchKind;
using haptics::devices::reamerKind;
using haptics::engine::MaterialSpec;
using storage::TraceSample;

/// A reamer that advances from @p from at @p speed [m/s] for @p ticks at 1 kHz, against 10 N.
std::vector<TraceSample> advancing(double from, double speed, int ticks) {
  std::vector<TraceSample> samples;
  for (int i = 0; i < ticks; ++i) {
    samples.push_back(
        {.travel = static_cast<float>(from + 1e-3 * speed * i),
         .velocity = static_cast<float>(speed),
         .force = 10.0F});
  }
  return samples;
}

haptics::engine::SceneSpec bone() {
  return {.model = MaterialSpec{.nodes = haptics::engine::parametricMaterial()}};
}

TEST(RenderedForceBins, CountReamingAtTheMeasuredSpeeds) {
  for (const double feed : {0.01e-3, 0.03e-3}) {  // reaming paper, "Experimental setup"
    RenderedForceBins bins(reamerKind(), bone());
    bins.add(advancing(0.0051, feed, 2000));
    const auto points = bins.points();
    ASSERT_EQ(points.size(), 1U) << feed;
    EXPECT_EQ(points.front().median, 10.0);
  }
}

TEST(RenderedForceBins, CountTheStrokesThatReachTheLimitOfTheFeed) {
  auto scene = bone();
  std::get<MaterialSpec>(scene.model).isRemoved = true;  // at most 2 mm/s
  RenderedForceBins bins(reamerKind(), scene);
  for (const double speed : {0.0019, 0.002, 0.0017, 0.0005}) {
    auto stroke = advancing(0.0101, speed, 50);
    stroke.back().landmark = 5;  // the stroke ends
    bins.add(stroke);
  }
  const auto points = bins.points();
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points.front().atMostFeed, 0.5);
  RenderedForceBins free(reamerKind(), bone());
  free.add(advancing(0.0101, 0.002, 50));
  EXPECT_EQ(free.points().front().atMostFeed, 0.0);
}

TEST(RenderedForceBins, LeaveOutAHandAtRest) {
  RenderedForceBins bins(reamerKind(), bone());
  auto samples = advancing(0.0, 0.03, 100);            // 3 mm, fast
  const auto resting = advancing(0.0105, 1e-5, 5000);  // a trembling hand at rest
  samples.insert(samples.end(), resting.begin(), resting.begin() + 4);
  bins.add(samples);
  const auto medians = bins.medians();
  EXPECT_EQ(medians.count(42), 0U);  // 10.5 mm in bins of 0.25 mm
  EXPECT_EQ(medians.size(), 12U);
}

TEST(RenderedForceBins, CountFastMovementFromAFixedSpeedOn) {
  // A punch: bins of an eightieth of 11 travel units; below 0.6875 units/s it is at rest.
  RenderedForceBins bins(punchKind(), {.model = haptics::engine::publishedElements(5)});
  std::vector<TraceSample> samples;
  for (int i = 0; i < 100; ++i)
    samples.push_back({.travel = 5.0F, .velocity = 20.0F, .force = 2.0F});
  for (int i = 0; i < 3; ++i) samples.push_back({.travel = 8.0F, .velocity = 0.6F, .force = 3.0F});
  for (int i = 0; i < 3; ++i) samples.push_back({.travel = 9.0F, .velocity = 0.7F, .force = 3.0F});
  bins.add(samples);
  const auto medians = bins.medians();
  EXPECT_EQ(medians.size(), 2U);
  EXPECT_EQ(medians.count(static_cast<int>(8.0 / (11.0 / 80.0))), 0U);
}

/// A punch that closes from open to shut at @p speed [unit/s] at 1 kHz against @p force [N].
template <typename Force>
std::vector<TraceSample> closing(double speed, Force force) {
  using Event = haptics::models::CutDetector<double>::Event;
  std::vector<TraceSample> samples;
  for (double travel = 0.0; travel <= 10.0; travel += 1e-3 * speed) {
    samples.push_back(
        {.travel = static_cast<float>(travel),
         .velocity = static_cast<float>(speed),
         .force = static_cast<float>(force(travel))});
  }
  samples.push_back({.travel = 10.0F, .landmark = static_cast<std::uint8_t>(Event::CutCompleted)});
  return samples;
}

TEST(RenderedForceBins, GiveACurveOfOneStrokeHoweverFastItWas) {
  const auto linear = [](double travel) { return 0.5 * travel; };
  for (const double speed : {2.0, 45.0, 400.0}) {  // 400: three bins a sample
    RenderedForceBins bins(punchKind(), {.model = haptics::engine::publishedElements(5)});
    bins.add(closing(speed, linear));
    const auto points = bins.points();
    ASSERT_GE(points.size(), 70U) << speed;
    for (const auto& point : points) {
      EXPECT_NEAR(point.median, linear(point.travel), 0.5 * 11.0 / 160.0) << speed;
      EXPECT_EQ(point.low, point.high) << "there is one stroke";
    }
  }
}

TEST(RenderedForceBins, CountEveryStrokeOnce) {
  RenderedForceBins bins(punchKind(), {.model = haptics::engine::publishedElements(5)});
  auto samples = closing(5.0, [](double) { return 1.0; });  // 2,000 samples
  for (int i = 0; i < 2; ++i) {
    const auto fast = closing(50.0, [](double) { return 3.0; });  // 200
    samples.insert(samples.end(), fast.begin(), fast.end());
  }
  bins.add(samples);
  for (const auto& [bin, median] : bins.medians()) EXPECT_EQ(median, 3.0) << bin;
  EXPECT_EQ(bins.points().front().low, 1.0);
}

TEST(RenderedForceBins, GiveNoPointWhereFewerThanHalfOfTheStrokesCame) {
  RenderedForceBins bins(punchKind(), {.model = haptics::engine::publishedElements(5)});
  const auto upTo = [](double end) {
    auto samples = closing(20.0, [](double travel) { return travel; });
    std::erase_if(samples, [&](const auto& one) { return one.landmark == 0 && one.travel > end; });
    return samples;
  };
  for (const double end : {3.0, 3.0, 6.0, 10.0}) bins.add(upTo(end));
  const auto points = bins.points();
  EXPECT_EQ(bins.strokes(), 4U);
  EXPECT_NEAR(points.back().travel, 6.0, 11.0 / 80.0);
  EXPECT_GT(bins.medians().rbegin()->first, points.back().bin) << "they have every bin";
}

TEST(RenderedForceBins, ReachAsDeepAsTheDataOfTheScene) {
  MaterialSpec deep{.nodes = haptics::engine::parametricMaterial()};
  deep.nodes.push_back({0.03, 900.0, 950.0});
  RenderedForceBins bins(reamerKind(), {.model = deep});
  bins.add(advancing(0.0290, 0.002, 100));
  EXPECT_FALSE(bins.points().empty());
  RenderedForceBins ordinary(reamerKind(), bone());
  ordinary.add(advancing(0.0290, 0.002, 100));  // beyond the device's stop at 20 mm
  EXPECT_TRUE(ordinary.points().empty());
}

}  // namespace rendered_force_bins_test
}  // namespace study
