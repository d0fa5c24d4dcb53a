#include "haptics/devices/hand.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace haptics::devices {
namespace {

/// Minimum-jerk path from 0 to 1 in unit time; speed() is its derivative.
double path(double tau) {
  return tau * tau * tau * (10.0 - tau * (15.0 - 6.0 * tau));
}
double speed(double tau) {
  return 30.0 * tau * tau * (1.0 - tau) * (1.0 - tau);
}

}  // namespace

SimulatedHand::SimulatedHand(const Person& person) : person_(person), random_(person.seed) {
  const bool isSound = person.closeTime > 0.0 && person.openTime > 0.0 && person.pauseTime >= 0.0 &&
                       person.holdTime >= 0.0 && person.stiffness > 0.0 && person.damping >= 0.0 &&
                       person.variation >= 0.0 && person.variation <= 0.5 &&
                       std::isfinite(person.open) && std::isfinite(person.closed);
  if (!isSound) throw std::invalid_argument("a simulated hand needs positive times and stiffness");
  beginCycle();
}

void SimulatedHand::beginCycle() noexcept {
  // The reach varies less than the time, because the handle has an end stop.
  constexpr double kReachVariationShare = 0.3;
  cycleReach_ = person_.open + (person_.closed - person_.open) *
                                   (1.0 + kReachVariationShare * person_.variation * deviation());
  closeTime_ = person_.closeTime * (1.0 + person_.variation * deviation());
}

SimulatedHand::Target SimulatedHand::target() const noexcept {
  const double distance = cycleReach_ - person_.open;
  double t = time_ - person_.pauseTime;
  if (t < 0.0) return {person_.open, 0.0};
  if (t < closeTime_) {
    const double tau = t / closeTime_;
    return {person_.open + distance * path(tau), distance * speed(tau) / closeTime_};
  }
  t -= closeTime_ + person_.holdTime;
  if (t < 0.0) return {cycleReach_, 0.0};
  const double tau = std::fmin(t / person_.openTime, 1.0);
  return {cycleReach_ - distance * path(tau), -distance * speed(tau) / person_.openTime};
}

double SimulatedHand::push(double travel, double velocity, double dt) noexcept {
  time_ += dt;
  const double cycle = person_.pauseTime + closeTime_ + person_.holdTime + person_.openTime;
  if (time_ >= cycle) {
    time_ -= cycle;
    beginCycle();
  }
  const Target wanted = target();
  return person_.stiffness * (wanted.position - travel) +
         person_.damping * (wanted.velocity - velocity);
}

double PointerHand::push(double travel, double velocity, double dt) noexcept {
  const double wanted = targetTravel_.load(std::memory_order_relaxed);
  const double step = std::clamp(wanted - position_, -grip_.speed * dt, grip_.speed * dt);
  position_ += step;
  const double push =
      grip_.stiffness * (position_ - travel) + grip_.damping * (step / dt - velocity);
  return std::clamp(push, -grip_.strength, grip_.strength);
}

}  // namespace haptics::devices
