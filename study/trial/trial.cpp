#include "study/trial/trial.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace study {
namespace {

using haptics::engine::ForceLimiter;
using haptics::engine::TickSample;

constexpr double kContactForce = 0.05;  // [N]: only a larger commanded force counts as contact

}  // namespace

TrialStatistics::TrialStatistics(const haptics::devices::DeviceKind& device, double rate)
    : rate_(rate), detector_(device.stroke) {}

/// Counts the ticks in which @p isNow is true, and its rising edges as occurrences.
void TrialStatistics::count(SafetyKind kind, bool isNow) {
  auto& tally = tallies_[static_cast<std::size_t>(kind)];
  if (isNow) ++tally.ticks;
  if (isNow && !tally.wasActiveBefore) ++tally.times;
  tally.wasActiveBefore = isNow;
}

void TrialStatistics::add(const TickSample& sample) {
  const auto isMarked = [&](TickSample::Mark mark) { return (sample.marks & mark) != 0; };
  const auto intervened = [&](ForceLimiter::Intervention what) {
    return (sample.interventions & what) != 0;
  };
  count(SafetyKind::TooFast, isMarked(TickSample::TooFast));
  count(SafetyKind::DeadManReleased, isMarked(TickSample::DeadManReleased));
  count(SafetyKind::NoSample, isMarked(TickSample::Invalid));
  count(SafetyKind::MissedPeriods, isMarked(TickSample::MissedPeriods));
  count(SafetyKind::SoftStart, isMarked(TickSample::SoftStart));
  count(SafetyKind::Saturated, intervened(ForceLimiter::Saturated));
  count(SafetyKind::Slewed, intervened(ForceLimiter::Slewed));
  count(SafetyKind::NotFinite, intervened(ForceLimiter::NotFinite));
  count(SafetyKind::Active, intervened(ForceLimiter::Active));
  count(SafetyKind::Damped, intervened(ForceLimiter::Damped));
  count(SafetyKind::TorqueSaturated, intervened(ForceLimiter::TorqueSaturated));
  count(SafetyKind::TorqueSlewed, intervened(ForceLimiter::TorqueSlewed));
  count(SafetyKind::TorqueActive, intervened(ForceLimiter::TorqueActive));
  leastEnergy_ = std::min(leastEnergy_, sample.energy);
  leastRotationEnergy_ = std::min(leastRotationEnergy_, sample.rotationEnergy);
  largestTorque_ = std::max(largestTorque_, std::abs(sample.torque));
  if (intervened(ForceLimiter::TorqueSaturated)) ++torqueSaturated_;
  ++ticks_;
  if ((sample.marks & TickSample::Invalid) != 0) ++invalid_;
  if ((sample.marks & TickSample::Undefined) != 0) ++undefined_;
  if ((sample.interventions & ForceLimiter::Saturated) != 0) ++saturated_;
  if ((sample.interventions & ForceLimiter::Slewed) != 0) ++slewed_;
  if (std::abs(sample.force) > kContactForce) ++contact_;
  largestForce_ = std::max(largestForce_, std::abs(sample.force));
  if ((sample.marks & (TickSample::Invalid | TickSample::Stopped)) != 0) return;
  using Event = haptics::engine::CutDetector::Event;
  const bool isSettling = isMarked(TickSample::SoftStart);
  if (detector_.feed(sample.travel, sample.force, isSettling) == Event::CutCompleted) {
    cuts_.push_back(detector_.lastCut());
  }
}

void TrialStatistics::fillIn(TrialRecord& record) const {
  const auto seconds = [&](std::int64_t ticks) { return static_cast<double>(ticks) / rate_; };
  record.nominalRate = rate_;
  record.ticks = ticks_;
  record.duration = seconds(ticks_);
  record.invalidTicks = invalid_;
  record.saturated = seconds(saturated_);
  record.slewed = seconds(slewed_);
  record.undefined = seconds(undefined_);
  record.contact = seconds(contact_);
  record.largestForce = largestForce_;
  record.cuts = cuts_;
  record.leastEnergy = leastEnergy_;
  record.leastRotationEnergy = leastRotationEnergy_;
  record.largestTorque = largestTorque_;
  record.torqueSaturated = seconds(torqueSaturated_);
  for (std::size_t i = 0; i < tallies_.size(); ++i) {
    if (tallies_[i].times == 0) continue;
    record.safety.push_back(
        {static_cast<SafetyKind>(i), tallies_[i].times, seconds(tallies_[i].ticks)});
  }
}

namespace {

using haptics::devices::DeviceStatus;
using haptics::engine::TickSample;

storage::TraceSample asTraceSample(const TickSample& sample) {
  return {
      .tick = static_cast<std::uint32_t>(sample.tick),
      .travel = static_cast<float>(sample.travel),
      .velocity = static_cast<float>(sample.velocity),
      .desired = static_cast<float>(sample.desired),
      .force = static_cast<float>(sample.force),
      .lateness = sample.lateness,
      .status = static_cast<std::uint8_t>(sample.status),
      .interventions = sample.interventions,
      .marks = sample.marks,
      .landmark = static_cast<std::uint8_t>(sample.landmark),
      .desiredTorque = static_cast<float>(sample.desiredTorque),
      .torque = static_cast<float>(sample.torque)};
}

TickSample asTickSample(const storage::TraceSample& sample) {
  TickSample tick;
  tick.tick = sample.tick;
  tick.travel = sample.travel;
  tick.velocity = sample.velocity;
  tick.desired = sample.desired;
  tick.force = sample.force;
  tick.lateness = sample.lateness;
  tick.status = static_cast<DeviceStatus>(sample.status);
  tick.interventions = sample.interventions;
  tick.marks = sample.marks;
  tick.desiredTorque = sample.desiredTorque;
  tick.torque = sample.torque;
  return tick;
}

}  // namespace

TrialRecord recordFrom(
    const std::vector<storage::TraceSample>& samples,
    const haptics::devices::DeviceKind& device,
    double rate) {
  TrialStatistics statistics(device, rate);
  for (const auto& sample : samples) statistics.add(asTickSample(sample));
  TrialRecord record{.travelUnit = std::string(device.travel.unit)};
  statistics.fillIn(record);
  record.traceSamples = static_cast<std::int64_t>(samples.size());
  return record;
}

Trial::Trial(haptics::devices::Device& device, Setup setup)
    : device_(device),
      scene_(setup.scene),
      slope_(haptics::engine::renderedSlope(
          setup.scene, *device.capabilities().kind, device.capabilities().rate)),
      engine_(device, setup.limits),
      storeChunk_(std::move(setup.storeChunk)),
      lacksDevice_(setup.needsDevice && device.capabilities().isSimulated),
      statistics_(*device.capabilities().kind, device.capabilities().rate) {
  chunk_.reserve(static_cast<std::size_t>(rate()));
  engine_.setScene(&scene_);
  device_.arm();  // last, since it may throw: without a complete object no destructor disarms
}

Trial::~Trial() {
  device_.command(0.0, 0.0);
  device_.disarm();
}

void Trial::keep(const TickSample& sample) {
  statistics_.add(sample);
  chunk_.push_back(asTraceSample(sample));
  if (static_cast<double>(chunk_.size()) >= rate()) keepChunk();
}

void Trial::keepChunk() {
  if (chunk_.empty()) return;
  storeChunk_(chunks_, chunk_);
  storedSamples_ += static_cast<std::int64_t>(chunk_.size());
  ++chunks_;
  chunk_.clear();
}

TrialRecord Trial::finish(TrialEnding ending) {
  device_.command(0.0, 0.0);
  const auto link = device_.link();
  const auto fault = device_.fault();
  device_.disarm();
  TrialRecord record{
      .device = device_.capabilities().name,
      .lacksDevice = lacksDevice_,
      .travelUnit = std::string(device_.capabilities().kind->travel.unit),
      .ending = ending,
      .passivity =
          {.stiffness = slope_.steepest,
           .period = 1.0 / rate(),
           .filterDelay = scene_.delay() / rate(),
           .limitCycle = slope_.limitCycle},
      .deviceDamping = device_.capabilities().damping,
      .link = link,
      .hasTorque = scene_.hasTorque(),
      .isTorqueRendered = scene_.hasTorque() && device_.capabilities().rendersTorque(),
      .deviceFault = base::describe(fault)};
  try {
    keepChunk();
  } catch (const std::exception&) {
    record.ending = TrialEnding::TraceLost;
  }
  statistics_.fillIn(record);
  record.traceSamples = storedSamples_;
  return record;
}

TrialRecord runOffline(Trial& trial, int cuts, double longest) {
  const double dt = 1.0 / trial.rate();
  const auto most = static_cast<std::int64_t>(longest * trial.rate());
  try {
    for (std::int64_t i = 0; i < most; ++i) {
      const auto sample = trial.step(dt);
      trial.keep(sample);
      if (sample.status == DeviceStatus::NotAnswering || sample.status == DeviceStatus::Faulted) {
        return trial.finish(TrialEnding::DeviceGone);
      }
      if (trial.isStopped()) return trial.finish(TrialEnding::Stopped);
      if (static_cast<int>(sample.cuts) >= cuts) return trial.finish(TrialEnding::Finished);
    }
  } catch (const std::exception&) {
    return trial.finish(TrialEnding::TraceLost);
  }
  return trial.finish(TrialEnding::TimedOut);
}

}  // namespace study
