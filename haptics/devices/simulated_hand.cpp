#include "haptics/devices/simulated_hand.h"

#include <cmath>
#include <stdexcept>

namespace haptics::devices {
namespace {

/// Minimum jerk from 0 to 1 over 1, and its speed.
double path(double tau) {
  return tau * tau * tau * (10.0 - tau * (15.0 - 6.0 * tau));
}
double speed(double tau) {
  return 30.0 * tau * tau * (1.0 - tau) * (1.0 - tau);
}

}  // namespace

SimulatedHand::SimulatedHand(const Person& person) : person_(person) {
  const bool isSound = person.closeTime > 0.0 && person.openTime > 0.0 && person.pauseTime >= 0.0 &&
                       person.holdTime >= 0.0 && person.stiffness > 0.0 && person.damping >= 0.0 &&
                       std::isfinite(person.open) && std::isfinite(person.closed);
  if (!isSound) throw std::invalid_argument("a simulated hand needs positive times and stiffness");
}

SimulatedHand::Target SimulatedHand::target() const noexcept {
  const double distance = person_.closed - person_.open;
  double t = time_ - person_.pauseTime;
  if (t < 0.0) return {person_.open, 0.0};
  if (t < person_.closeTime) {
    const double tau = t / person_.closeTime;
    return {person_.open + distance * path(tau), distance * speed(tau) / person_.closeTime};
  }
  t -= person_.closeTime + person_.holdTime;
  if (t < 0.0) return {person_.closed, 0.0};
  const double tau = std::fmin(t / person_.openTime, 1.0);
  return {person_.closed - distance * path(tau), -distance * speed(tau) / person_.openTime};
}

double SimulatedHand::push(double travel, double velocity, double dt) noexcept {
  time_ += dt;
  const double cycle = person_.pauseTime + person_.closeTime + person_.holdTime + person_.openTime;
  if (time_ >= cycle) time_ -= cycle;
  const Target wanted = target();
  return person_.stiffness * (wanted.position - travel) +
         person_.damping * (wanted.velocity - velocity);
}

}  // namespace haptics::devices
