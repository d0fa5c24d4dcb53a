#include "haptics/engine/force_limiter.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace haptics::engine {

ForceLimiter::ForceLimiter(double most, double rate, std::uint8_t saturated, std::uint8_t slewed)
    : largest_(most), rate_(rate), saturationFlag_(saturated), slewFlag_(slewed) {
  const auto isSound = [](double value) { return std::isfinite(value) && value > 0.0; };
  if (!isSound(most) || !isSound(rate)) {
    throw std::invalid_argument("a limit of force or torque must be a positive number");
  }
}

ForceLimiter::ForceLimiter(const SafetyLimits& limits)
    : ForceLimiter(limits.maxForce, limits.maxRate, Saturated, Slewed) {}

ForceLimiter ForceLimiter::forTorque(const SafetyLimits& limits) {
  return {limits.maxTorque, limits.maxTorqueRate, TorqueSaturated, TorqueSlewed};
}

ForceLimiter::Limited ForceLimiter::limit(double desired, double dt) noexcept {
  Limited result;
  // With an undefined force or time step no change of the last force is known to be safe: return 0.
  if (!std::isfinite(desired) || !(dt > 0.0)) {
    last_ = 0.0;
    result.interventions = NotFinite;
    return result;
  }
  double force = std::clamp(desired, -largest_, largest_);
  if (force != desired) result.interventions |= saturationFlag_;

  // Slew-limit after saturation, so that a force above the maximum rises no faster than one below
  // it.
  const double step = rate_ * dt;
  const double slewed = std::clamp(force, last_ - step, last_ + step);
  if (slewed != force) result.interventions |= slewFlag_;

  last_ = std::isfinite(slewed) ? slewed : 0.0;
  result.force = last_;
  return result;
}

void ForceGate::close() noexcept {
  gain_ = 0.0;
  silence_ = 0.0;
  isWaiting_ = true;
}

std::uint8_t ForceGate::closingReasons(const Input& input, double dt) noexcept {
  std::uint8_t reasons = None;
  silence_ = input.isMeasured ? 0.0 : silence_ + dt;
  if (!input.isMeasured) reasons |= NoSample;
  if (!input.isDeadManHeld) reasons |= DeadManReleased;
  if (!(std::abs(input.velocity) <= limits_.maxVelocity)) reasons |= TooFast;  // NaN is too fast
  return reasons;
}

ForceGate::Output ForceGate::step(const Input& input, double dt) noexcept {
  Output output{.reasons = closingReasons(input, dt)};
  output.isSilenceTooLong = silence_ > limits_.longestSilence;
  const double step = dt / limits_.rampTime;
  if (input.missedPeriods > 1) {
    output.reasons |= MissedPeriods;
    gain_ = std::max(
        0.0,
        gain_ - (input.missedPeriods - 1) * step);  // as much as one fading tick per missed period
  }

  // Bridge one missing sample; 1.5 ticks instead of 1 makes the comparison safe against rounding.
  const bool isBridged = output.reasons == NoSample && silence_ < 1.5 * dt;
  constexpr std::uint8_t kClosing = TooFast | DeadManReleased | NoSample;
  if ((output.reasons & kClosing) != 0) {
    if (!isBridged) {
      gain_ = std::max(0.0, gain_ - step);
      isWaiting_ = true;
    }
  } else {
    isWaiting_ =
        isWaiting_ && !(std::abs(input.desired) <= limits_.softStartShare * limits_.maxForce);
    gain_ = isWaiting_ ? std::max(0.0, gain_ - step) : std::min(1.0, gain_ + step);
    if (gain_ < 1.0) output.reasons |= SoftStart;
  }
  output.gain = gain_;
  return output;
}

}  // namespace haptics::engine
