#include "study/trial/trial_statistics.h"

#include <algorithm>
#include <cmath>

namespace study {
namespace {

using haptics::engine::ForceLimiter;
using haptics::engine::TickSample;

constexpr double kFelt = 0.05;  // [N]: smaller forces do not count as contact

}  // namespace

TrialStatistics::TrialStatistics(const haptics::devices::DeviceKind& device, double rate)
    : rate_(rate), detector_(device.stroke) {}

/// Counts ticks, and rising edges as occurrences.
void TrialStatistics::count(SafetyKind kind, bool isNow) {
  auto& tally = tallies_[static_cast<std::size_t>(kind)];
  if (isNow) ++tally.ticks;
  if (isNow && !tally.wasBefore) ++tally.times;
  tally.wasBefore = isNow;
}

void TrialStatistics::add(const TickSample& sample) {
  const auto isMarked = [&](TickSample::Mark mark) { return (sample.marks & mark) != 0; };
  const auto intervened = [&](ForceLimiter::Intervention what) {
    return (sample.interventions & what) != 0;
  };
  count(SafetyKind::TooFast, isMarked(TickSample::TooFast));
  count(SafetyKind::Released, isMarked(TickSample::Released));
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
  leastTurnEnergy_ = std::min(leastTurnEnergy_, sample.turnEnergy);
  largestTorque_ = std::max(largestTorque_, std::abs(sample.torque));
  if (intervened(ForceLimiter::TorqueSaturated)) ++torqueSaturated_;
  ++ticks_;
  if ((sample.marks & TickSample::Invalid) != 0) ++invalid_;
  if ((sample.marks & TickSample::Undefined) != 0) ++undefined_;
  if ((sample.interventions & ForceLimiter::Saturated) != 0) ++saturated_;
  if ((sample.interventions & ForceLimiter::Slewed) != 0) ++slewed_;
  if (std::abs(sample.force) > kFelt) ++contact_;
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
  record.leastTurnEnergy = leastTurnEnergy_;
  record.largestTorque = largestTorque_;
  record.torqueSaturated = seconds(torqueSaturated_);
  for (std::size_t i = 0; i < tallies_.size(); ++i) {
    if (tallies_[i].times == 0) continue;
    record.safety.push_back(
        {static_cast<SafetyKind>(i), tallies_[i].times, seconds(tallies_[i].ticks)});
  }
}

}  // namespace study
