// A trial in real time with its three threads. Short, so that the thread sanitizer can run it.
#include "study/trial/live_trial.h"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "haptics/devices/punch/punch_kind.h"
#include "haptics/devices/simulated_device.h"
#include "study/trial/device_set.h"
#include "tests/study/faulting_device.h"

namespace study {
namespace live_trial_test {

using namespace std::chrono_literals;
using storage::TraceSample;

class LiveTrialTest : public testing::Test {
 protected:
  LiveTrialTest()
      : hand_(simulatedHandFor(need_, 7, "surgeons", 0)),
        device_(haptics::devices::punchKind(), *hand_),
        trial_(
            device_,
            {.scene = {.model = haptics::engine::FiniteElementsSpec{}},
             .limits = {.maxForce = 8.0, .maxRate = 500.0},
             .storeChunk = [this](int, const std::vector<TraceSample>& samples) {
               keep(samples);
             }}) {}

  void keep(const std::vector<TraceSample>& samples) {
    if (isDiskFull_) throw storage::StorageError("the disk is full");
    kept_.insert(kept_.end(), samples.begin(), samples.end());
  }

  /// Waits until @p isThere holds; a minute is no measure of time, but the end of a test that
  /// hangs.
  static bool wait(const std::function<bool()>& isThere) {
    const auto end = std::chrono::steady_clock::now() + 60s;
    while (!isThere() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(1ms);
    return isThere();
  }

  protocols::DeviceRequirement need_{
      .id = "punch",
      .kind = &haptics::devices::punchKind(),
      .maxForce = 8.0,
      .maxForceRate = 500.0};
  std::unique_ptr<haptics::devices::Hand> hand_;
  haptics::devices::SimulatedDevice device_;
  std::vector<TraceSample> kept_;
  std::atomic<bool> isDiskFull_{false};
  Trial trial_;
};

TEST_F(LiveTrialTest, StoresEverySampleInOrder) {
  LiveTrial live(trial_);
  ASSERT_TRUE(wait([&] { return live.status().ticks >= 300; }));
  const auto record = live.finish(TrialEnding::Finished);
  EXPECT_EQ(record.lostSamples, 0);
  EXPECT_EQ(static_cast<std::int64_t>(kept_.size()), record.ticks);
  for (std::size_t i = 0; i < kept_.size(); ++i) ASSERT_EQ(kept_[i].tick, i);
  ASSERT_TRUE(record.achievedRate);
  ASSERT_TRUE(record.latenessMedian);
  EXPECT_LE(*record.latenessMedian, *record.latenessP99);
  EXPECT_LE(*record.latenessP99, *record.latenessLargest);
}

TEST_F(LiveTrialTest, ShowsTheForceDuringTheTrial) {
  LiveTrial live(trial_);
  haptics::engine::TickSample sample;
  ASSERT_TRUE(wait([&] { return live.nextToPlot(sample) && sample.travel > 1.0; }));
  EXPECT_GT(live.status().travel, 0.0);
}

TEST_F(LiveTrialTest, SwitchesTheForceOffWhenStopIsPressed) {
  LiveTrial live(trial_);
  ASSERT_TRUE(wait([&] { return live.status().force > 0.5; }));
  live.stop();
  const auto stopped = live.status().ticks + 1;  // one tick may have been in progress
  ASSERT_TRUE(wait([&] { return live.status().ticks > stopped; }));
  const auto record = live.finish(TrialEnding::Stopped);
  EXPECT_EQ(record.ending, TrialEnding::Stopped);
  EXPECT_EQ(device_.commandedForce(), 0.0);
  EXPECT_EQ(kept_.back().force, 0.0F);
}

TEST_F(LiveTrialTest, ReportsThatTheDeviceIsGone) {
  LiveTrial live(trial_);
  ASSERT_TRUE(wait([&] { return live.status().ticks >= 20; }));
  device_.unplug();
  ASSERT_TRUE(wait([&] { return live.status().isDeviceGone; }));
  EXPECT_EQ(live.finish(TrialEnding::Finished).ending, TrialEnding::DeviceGone);
}

TEST_F(LiveTrialTest, StopsIfTheDeviceReportsAFault) {
  tests::FaultingDevice device;
  Trial trial(
      device,
      {.scene = {.model = haptics::engine::FiniteElementsSpec{}},
       .limits = {.maxForce = 8.0, .maxRate = 500.0},
       .storeChunk = [](int, const std::vector<TraceSample>&) {}});
  LiveTrial live(trial);
  ASSERT_TRUE(wait([&] { return live.status().ticks >= 20; }));
  device.fail();
  ASSERT_TRUE(wait([&] { return live.status().isDeviceGone; }));
  EXPECT_TRUE(trial.isStopped());
  const auto record = live.finish(TrialEnding::Finished);
  EXPECT_EQ(record.ending, TrialEnding::DeviceGone);
  EXPECT_EQ(record.deviceFault, "The encoder has failed.");
}

TEST_F(LiveTrialTest, StopsIfSamplesCannotBeStored) {
  isDiskFull_ = true;
  LiveTrial live(trial_);
  ASSERT_TRUE(wait([&] { return live.status().isTraceLost; }));
  EXPECT_EQ(live.finish(TrialEnding::Finished).ending, TrialEnding::TraceLost);
  EXPECT_EQ(device_.commandedForce(), 0.0);
}

TEST_F(LiveTrialTest, HasNoForceOnceSamplesCannotBeStored) {
  LiveTrial live(trial_);
  ASSERT_TRUE(wait([&] { return live.status().force > 0.5; }));
  isDiskFull_ = true;  // before the next chunk, which is due within a second
  ASSERT_TRUE(wait([&] { return live.status().isTraceLost; }));

  EXPECT_TRUE(trial_.isStopped()) << "before anybody finishes the trial";
  const auto stopped = live.status().ticks + 1;  // one tick may have been in progress
  ASSERT_TRUE(wait([&] { return live.status().ticks >= stopped + 200; }));
  haptics::engine::TickSample sample;
  int seen = 0;
  while (live.nextToPlot(sample)) {
    if (sample.tick <= stopped) continue;
    ++seen;
    ASSERT_EQ(sample.force, 0.0) << "tick " << sample.tick;
  }
  EXPECT_GT(seen, 100);
  EXPECT_EQ(live.status().force, 0.0);
}

}  // namespace live_trial_test
}  // namespace study
