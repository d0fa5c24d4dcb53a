#include "haptics/engine/force_gate.h"

#include <algorithm>
#include <cmath>

namespace haptics::engine {

void ForceGate::shut() noexcept {
  gain_ = 0.0;
  silence_ = 0.0;
  isWaiting_ = true;
}

std::uint8_t ForceGate::closingReasons(const Input& input, double dt) noexcept {
  std::uint8_t reasons = None;
  silence_ = input.isMeasured ? 0.0 : silence_ + dt;
  if (!input.isMeasured) reasons |= NoSample;
  if (!input.isHeld) reasons |= Released;
  if (!(std::abs(input.velocity) <= limits_.maxVelocity)) reasons |= TooFast;
  return reasons;
}

ForceGate::Output ForceGate::step(const Input& input, double dt) noexcept {
  Output output{.reasons = closingReasons(input, dt)};
  output.isPatienceOver = silence_ > limits_.patience;
  const double step = dt / limits_.rampTime;
  if (input.lostBeats > 1) {
    output.reasons |= LostBeats;
    gain_ = std::max(0.0, gain_ - (input.lostBeats - 1) * step);
  }

  // One missing sample is held, by a hair more than a tick so that rounding does not decide.
  const bool isBridged = output.reasons == NoSample && silence_ < 1.5 * dt;
  constexpr std::uint8_t kClosing = TooFast | Released | NoSample;
  if ((output.reasons & kClosing) != 0) {
    if (!isBridged) {
      gain_ = std::max(0.0, gain_ - step);
      isWaiting_ = true;
    }
  } else {
    isWaiting_ = isWaiting_ && !(std::abs(input.desired) <= limits_.quietShare * limits_.maxForce);
    gain_ = isWaiting_ ? std::max(0.0, gain_ - step) : std::min(1.0, gain_ + step);
    if (gain_ < 1.0) output.reasons |= SoftStart;
  }
  output.gain = gain_;
  return output;
}

}  // namespace haptics::engine
