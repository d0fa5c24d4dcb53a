// What a trial stores and counts, and its verdict.
#include "study/trial/trial.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "haptics/devices/punch/punch_kind.h"
#include "haptics/devices/simulated_device.h"
#include "study/trial/device_set.h"
#include "tests/study/faulting_device.h"
#include "tests/study/made_study.h"

namespace study {
namespace trial_test {

using storage::TraceSample;

bool says(const TrialRecord::Judgement& judgement, std::string_view key) {
  const auto& reasons = judgement.reasons;
  return std::any_of(
      reasons.begin(), reasons.end(), [&](const auto& reason) { return reason.key() == key; });
}

/// A punch with a simulated hand, and a trial on it that is stored in memory.
class TrialTest : public testing::Test {
 protected:
  TrialTest()
      : hand_(simulatedHandFor(need_, 7, "surgeons", 0)),
        device_(haptics::devices::punchKind(), *hand_) {}

  Trial::Setup setup(double maxForce = 8.0) {
    return {
        .scene = {.model = haptics::engine::FiniteElementsSpec{}},
        .limits = {.maxForce = maxForce, .maxRate = 500.0},
        .storeChunk = [this](int number, const std::vector<TraceSample>& samples) {
          EXPECT_EQ(number, static_cast<int>(chunks_.size()));
          chunks_.push_back(samples);
        }};
  }

  std::vector<TraceSample> samples() const {
    std::vector<TraceSample> all;
    for (const auto& chunk : chunks_) all.insert(all.end(), chunk.begin(), chunk.end());
    return all;
  }

  protocols::DeviceRequirement need_{
      .id = "punch",
      .kind = &haptics::devices::punchKind(),
      .maxForce = 8.0,
      .maxForceRate = 500.0};
  std::unique_ptr<haptics::devices::Hand> hand_;
  haptics::devices::SimulatedDevice device_;
  std::vector<std::vector<TraceSample>> chunks_;
};

TEST_F(TrialTest, WarnsOfLeapsOfThePositionAndRecordsThem) {
  Trial trial(device_, setup());
  auto record = runOffline(trial, 3, 60.0);
  const auto link = [&] {
    return storage::describe({.kind = EventKind::DeviceLink, .values = valuesOf(record.link)});
  };
  EXPECT_FALSE(says(record.judgement(), "trial.leaps"));
  EXPECT_EQ(link().find("leaps"), std::string::npos) << link();
  record.link.leaps = 2;
  EXPECT_EQ(record.judgement().verdict, Verdict::Warn);
  EXPECT_TRUE(says(record.judgement(), "trial.leaps"));
  EXPECT_TRUE(link().ends_with(", leaps of the position 2")) << link();
  record.link.leaps = 1;
  EXPECT_TRUE(says(record.judgement(), "trial.leaps.one"));
}

TEST_F(TrialTest, IsStoredCompletelyInChunksOfASecond) {
  Trial trial(device_, setup());
  const auto record = runOffline(trial, 3, 60.0);
  EXPECT_EQ(record.ending, TrialEnding::Finished);
  EXPECT_EQ(record.cuts.size(), 3U);
  ASSERT_GE(chunks_.size(), 2U);
  for (std::size_t i = 0; i + 1 < chunks_.size(); ++i) EXPECT_EQ(chunks_[i].size(), 1000U);
  const auto all = samples();
  EXPECT_EQ(static_cast<std::int64_t>(all.size()), record.ticks);
  EXPECT_EQ(record.traceSamples, record.ticks);
  for (std::size_t i = 0; i < all.size(); ++i) ASSERT_EQ(all[i].tick, i);
  EXPECT_EQ(record.judgement().verdict, Verdict::Pass)
      << base::describe(record.judgement().reasons);
}

TEST_F(TrialTest, RecordsWhatKeptTheForceFromTheHand) {
  Trial trial(device_, setup());
  for (int i = 0; i < 3000; ++i) {
    if (i == 1500) device_.hold(false);
    if (i == 1600) device_.hold(true);
    trial.keep(trial.step(1e-3, i == 2500 ? 5 : 0));
  }
  const auto record = trial.finish(TrialEnding::Finished);
  const auto timesOf = [&](SafetyKind kind) {
    for (const auto& event : record.safety) {
      if (event.kind == kind) return event;
    }
    return SafetyEvent{.kind = kind};
  };
  EXPECT_EQ(timesOf(SafetyKind::DeadManReleased).times, 1);
  EXPECT_NEAR(timesOf(SafetyKind::DeadManReleased).duration, 0.1, 1e-9);
  EXPECT_EQ(timesOf(SafetyKind::MissedPeriods).times, 1);
  // at the beginning, and after the dead-man switch
  EXPECT_GE(timesOf(SafetyKind::SoftStart).times, 2);
  EXPECT_EQ(timesOf(SafetyKind::TooFast).times, 0);
  const auto judgement = record.judgement();
  EXPECT_EQ(judgement.verdict, Verdict::Warn);
  EXPECT_TRUE(says(judgement, "trial.released")) << base::describe(judgement.reasons);
  EXPECT_TRUE(says(judgement, "trial.lost_beats")) << base::describe(judgement.reasons);
  int released = 0;
  for (const auto& sample : samples()) {
    released += (sample.marks & haptics::engine::TickSample::DeadManReleased) != 0 ? 1 : 0;
  }
  EXPECT_EQ(released, 100);
}

TEST_F(TrialTest, HasTheCountsOfItsTrace) {
  Trial trial(device_, setup(3.0));  // less than the scene asks for
  const auto record = runOffline(trial, 3, 60.0);
  double largest = 0.0;
  double saturated = 0.0;
  for (const auto& sample : samples()) {
    largest = std::max(largest, static_cast<double>(sample.force));
    const bool isCutOff = (sample.interventions & haptics::engine::ForceLimiter::Saturated) != 0;
    saturated += isCutOff ? 1e-3 : 0.0;
  }
  EXPECT_LE(largest, 3.0);
  EXPECT_NEAR(record.largestForce, largest, 1e-6);
  EXPECT_GT(record.saturated, 0.0);
  EXPECT_NEAR(record.saturated, saturated, 1e-9);
  EXPECT_EQ(record.judgement().verdict, Verdict::Warn);
  EXPECT_TRUE(says(record.judgement(), "trial.cut_off"));
}

TEST_F(TrialTest, SwitchesTheForceOffIfTheDeviceIsGoneAndReportsIt) {
  Trial trial(device_, setup());
  for (int i = 0; i < 900; ++i) trial.keep(trial.step(1e-3));
  device_.unplug();
  const auto sample = trial.step(1e-3);
  EXPECT_EQ(sample.force, 0.0);
  EXPECT_EQ(device_.commandedForce(), 0.0);
  trial.keep(sample);
  const auto record = trial.finish(TrialEnding::DeviceGone);
  EXPECT_EQ(record.invalidTicks, 1);
  EXPECT_EQ(record.judgement().verdict, Verdict::Fail);
  EXPECT_EQ(
      record.judgement().reasons.front().arguments().front(),
      base::Argument(std::string("aborted_hardware")));
}

TEST_F(TrialTest, EndsWithTheMessageOfAFaultyDevice) {
  tests::FaultingDevice device;
  Trial trial(device, setup());
  for (int i = 0; i < 10; ++i) trial.keep(trial.step(1e-3));
  device.fail();
  const auto record = runOffline(trial, 3, 60.0);
  EXPECT_TRUE(trial.isStopped());
  EXPECT_EQ(record.ending, TrialEnding::DeviceGone);
  EXPECT_EQ(record.ticks, 11) << "in its first faulty tick";
  EXPECT_EQ(record.deviceFault, "The encoder has failed.");
  EXPECT_EQ(record.judgement().verdict, Verdict::Fail);
}

TEST_F(TrialTest, HasNoForceFromTheTickAfterStopOn) {
  Trial trial(device_, setup());
  double felt = 0.0;
  for (int i = 0; i < 20'000 && felt < 1.0; ++i) felt = trial.step(1e-3).force;
  ASSERT_GE(felt, 1.0);
  trial.stop();
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(trial.step(1e-3).force, 0.0);
    EXPECT_EQ(device_.commandedForce(), 0.0);
  }
}

TEST_F(TrialTest, ReportsALostTraceIfSamplesCannotBeStored) {
  auto setting = setup();
  setting.storeChunk = [](int, const std::vector<TraceSample>&) {
    throw storage::StorageError("the disk is full");
  };
  Trial trial(device_, std::move(setting));
  const auto record = runOffline(trial, 3, 60.0);
  EXPECT_EQ(record.ending, TrialEnding::TraceLost);
  EXPECT_EQ(record.judgement().verdict, Verdict::Fail);
}

TEST_F(TrialTest, EndsAfterTheTimeLimitWithoutACut) {
  Trial trial(device_, setup());
  EXPECT_EQ(runOffline(trial, 1000, 2.0).ending, TrialEnding::TimedOut);
}

// Both sides of every limit of the verdict.
TrialRecord sound() {
  return {
      .ticks = 10'000,
      .achievedRate = 1000.0,
      .lateTicks = 0,
      .contact = 4.0,
      .traceSamples = 10'000};
}

Verdict judged(const std::function<void(TrialRecord&)>& change) {
  auto record = sound();
  change(record);
  const auto judgement = record.judgement();
  EXPECT_EQ(judgement.reasons.empty(), judgement.verdict == Verdict::Pass);
  return judgement.verdict;
}

TEST(TrialJudgement, PassesWarnsAndFailsByTheRate) {
  EXPECT_EQ(judged([](auto& r) { r.achievedRate = 950.0; }), Verdict::Pass);
  EXPECT_EQ(judged([](auto& r) { r.achievedRate = 949.0; }), Verdict::Warn);
  EXPECT_EQ(judged([](auto& r) { r.achievedRate = 900.0; }), Verdict::Warn);
  EXPECT_EQ(judged([](auto& r) { r.achievedRate = 899.0; }), Verdict::Fail);
  EXPECT_EQ(judged([](auto& r) { r.achievedRate.reset(); }), Verdict::Pass);  // simulated time
}

TEST(TrialJudgement, WarnsOfLateTicksSaturationAndUndefinedForces) {
  EXPECT_EQ(judged([](auto& r) { r.lateTicks = 100; }), Verdict::Pass);
  EXPECT_EQ(judged([](auto& r) { r.lateTicks = 101; }), Verdict::Warn);
  EXPECT_EQ(judged([](auto& r) { r.saturated = 0.2; }), Verdict::Pass);
  EXPECT_EQ(judged([](auto& r) { r.saturated = 0.201; }), Verdict::Warn);
  EXPECT_EQ(judged([](auto& r) { r.undefined = 0.001; }), Verdict::Warn);
}

TEST(TrialJudgement, FailsIfSamplesAreMissingOrTheTrialBrokeOff) {
  EXPECT_EQ(judged([](auto& r) { r.traceSamples = 9'999; }), Verdict::Fail);
  EXPECT_EQ(judged([](auto& r) { r.lostSamples = 1; }), Verdict::Fail);
  EXPECT_EQ(judged([](auto& r) { r.invalidTicks = 1; }), Verdict::Fail);
  EXPECT_EQ(judged([](auto& r) { r.ending = TrialEnding::Stopped; }), Verdict::Fail);
}

TEST(TrialJudgement, GivesEveryReasonAndTheWorstVerdict) {
  auto record = sound();
  record.achievedRate = 940.0;
  record.lostSamples = 2;
  record.traceSamples = 9'998;
  const auto judgement = record.judgement();
  EXPECT_EQ(judgement.verdict, Verdict::Fail);
  EXPECT_TRUE(says(judgement, "trial.rate"));
  EXPECT_TRUE(says(judgement, "trial.samples_lost"));
}

}  // namespace trial_test
}  // namespace study
