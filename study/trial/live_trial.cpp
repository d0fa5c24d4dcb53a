#include "study/trial/live_trial.h"

#include <chrono>
#include <exception>

#include "haptics/timing/monotonic_clock.h"

namespace study {
namespace {

using haptics::devices::DeviceStatus;
using haptics::engine::TickSample;

constexpr std::chrono::milliseconds kDrainInterval{10};

}  // namespace

LiveTrial::LiveTrial(Trial& trial) : trial_(trial) {
  recorder_ = std::jthread([this](const std::stop_token& stop) { record(stop); });
  loop_.emplace(
      haptics::engine::RealtimeLoop::Options{.rate = trial.rate(), .pacer = trial.pacer()},
      [this](double dt, double lateness) { tick(dt, lateness); });
}

LiveTrial::~LiveTrial() {
  if (!isFinished_) {
    trial_.stop();
    finish(TrialEnding::ProgramEnded);
  }
}

void LiveTrial::tick(double dt, double lateness) noexcept {
  const std::int64_t sampleTime = haptics::timing::now();
  // @p lateness is in µs: the quotient is the number of whole periods without a tick.
  TickSample sample = trial_.step(dt, static_cast<int>(lateness * 1e-6 / dt));
  sample.lateness = static_cast<float>(lateness);
  // Each value is displayed by itself and orders no other memory access, so relaxed order is
  // enough.
  cuts_.store(static_cast<int>(sample.cuts), std::memory_order_relaxed);
  travel_.store(sample.travel, std::memory_order_relaxed);
  force_.store(sample.force, std::memory_order_relaxed);
  sampleTime_.store(sampleTime, std::memory_order_relaxed);
  onCutLandmark(sample.landmark);
  if (sample.status == DeviceStatus::NotAnswering || sample.status == DeviceStatus::Faulted) {
    isDeviceGone_.store(true, std::memory_order_relaxed);
  }
  storeRing_->push(sample);
}

void LiveTrial::onCutLandmark(haptics::models::CutDetector<double>::Event landmark) noexcept {
  using enum haptics::models::CutDetector<double>::Event;
  if (landmark == Yield || landmark == BottomOut) {
    isCutThrough_.store(true, std::memory_order_relaxed);
  } else if (landmark == CutCompleted) {
    isCutThrough_.store(false, std::memory_order_relaxed);
  }
}

void LiveTrial::record(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    std::this_thread::sleep_for(kDrainInterval);
    drain();
  }
  drain();
}

void LiveTrial::drain() {
  TickSample sample;
  while (storeRing_->pop(sample)) {
    plotRing_->push(sample);
    if (isTraceLost_.load(std::memory_order_relaxed)) continue;
    try {
      trial_.keep(sample);
    } catch (const std::exception&) {
      trial_.stop();  // a participant must not feel samples that are not recorded
      isTraceLost_.store(true, std::memory_order_relaxed);
    }
  }
}

LiveTrial::Status LiveTrial::status() const noexcept {
  return {
      .cuts = cuts_.load(std::memory_order_relaxed),
      .travel = travel_.load(std::memory_order_relaxed),
      .force = force_.load(std::memory_order_relaxed),
      .sampleTime = sampleTime_.load(std::memory_order_relaxed),
      .isCutThrough = isCutThrough_.load(std::memory_order_relaxed),
      .ticks = loop_->ticks(),
      .lateTicks = loop_->lateTicks(),
      .isRealtime = loop_->isRealtime(),
      .isDeviceGone = isDeviceGone_.load(std::memory_order_relaxed),
      .isTraceLost = isTraceLost_.load(std::memory_order_relaxed)};
}

TrialRecord LiveTrial::finish(TrialEnding ending) {
  isFinished_ = true;
  // First the loop, so that no sample is pushed any more; then the recorder, which empties the ring
  // once more before it ends.
  const auto& report = loop_->finish();
  recorder_.request_stop();
  recorder_.join();
  if (isDeviceGone_.load()) ending = TrialEnding::DeviceGone;
  if (isTraceLost_.load()) ending = TrialEnding::TraceLost;
  TrialRecord record = trial_.finish(ending);
  record.ticks = static_cast<std::int64_t>(report.ticks);
  record.lostSamples = static_cast<std::int64_t>(storeRing_->lost());
  if (report.ticks > 1 && report.seconds > 0.0) {
    record.achievedRate = static_cast<double>(report.ticks - 1) / report.seconds;
  }
  record.latenessMedian = report.lateness.quantile(0.5);
  record.latenessP99 = report.lateness.quantile(0.99);
  record.latenessLargest = report.lateness.largest();
  constexpr double kSecondsPerMicrosecond = 1e-6;
  record.passivity.lateness = kSecondsPerMicrosecond * report.lateness.quantile(0.999);
  record.lateTicks = static_cast<std::int64_t>(report.lateTicks);
  record.hostPauses = static_cast<std::int64_t>(report.hostPauses);
  return record;
}

TrialRecord runRealtime(Trial& trial, int cuts, double longest) {
  LiveTrial live(trial);
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(longest);
  for (;;) {
    const auto status = live.status();
    if (status.cuts >= cuts || status.isDeviceGone || status.isTraceLost) {
      return live.finish(TrialEnding::Finished);
    }
    if (trial.isStopped()) return live.finish(TrialEnding::Stopped);
    if (std::chrono::steady_clock::now() >= until) return live.finish(TrialEnding::TimedOut);
    std::this_thread::sleep_for(kDrainInterval);
  }
}

}  // namespace study
