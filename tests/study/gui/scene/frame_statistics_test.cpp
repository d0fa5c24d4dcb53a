#include "study/gui/scene/frame_statistics.h"

#include <gtest/gtest.h>

#include "study/storage/event_log.h"

namespace study::gui::scene {
namespace frame_statistics_test {

constexpr std::int64_t kMs = 1'000'000;

TEST(FrameStatistics, IsEmptyBeforeTheFirstFrame) {
  const FrameStatistics statistics(16 * kMs);
  const auto report = statistics.report();
  EXPECT_EQ(report.frames, 0);
  EXPECT_EQ(report.rate, 0.0);
  EXPECT_EQ(report.latencyMedian, 0.0);
}

TEST(FrameStatistics, CountsDroppedFrames) {
  FrameStatistics statistics(16 * kMs);
  for (const int shown : {100, 116, 132, 180, 196}) {  // two frames are missing before 180
    statistics.add(shown * kMs, (shown - 9) * kMs);
  }
  const auto report = statistics.report();
  EXPECT_EQ(report.frames, 5);
  EXPECT_DOUBLE_EQ(statistics.longest(), 48.0);
  EXPECT_EQ(report.dropped, 2);
  EXPECT_NEAR(report.rate, 4.0 / 0.096, 1e-9);
  EXPECT_NEAR(report.frameMedian, 16.0, 1.1);  // bins are a sixteenth wide
  EXPECT_NEAR(report.frameP99, 48.0, 3.1);
  EXPECT_NEAR(report.latencyMedian, 9.0, 0.6);
  EXPECT_EQ(report.period, 16.0);
}

TEST(FrameStatistics, HasNoLatencyWithoutADeviceSample) {
  FrameStatistics statistics(16 * kMs);
  statistics.add(100 * kMs, 0);
  statistics.add(116 * kMs, 0);
  EXPECT_EQ(statistics.report().latencyP99, 0.0);
}

TEST(ViewReport, DescribesTheNumbersAndTheRenderer) {
  const ViewReport report{
      .renderer = "a card", .frames = 120, .dropped = 3, .rate = 59.94, .latencyMedian = 12.3};
  const std::string words =
      storage::describe(storage::Event{.kind = EventKind::View, .values = valuesOf(report)});
  EXPECT_NE(words.find("frames 120, dropped 3, 59.9 1/s"), std::string::npos) << words;
  EXPECT_NE(words.find("latency p50 12.3 ms"), std::string::npos) << words;
  EXPECT_NE(words.find("drawn by a card"), std::string::npos) << words;
}

}  // namespace frame_statistics_test
}  // namespace study::gui::scene
