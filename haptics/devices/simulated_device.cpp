#include "haptics/devices/simulated_device.h"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace haptics::devices {

SimulatedDevice::SimulatedDevice(Capabilities capabilities, const Mechanism& mechanism, Hand& hand)
    : capabilities_(std::move(capabilities)), mechanism_(mechanism), hand_(hand) {
  const bool isSound = mechanism.mass > 0.0 && mechanism.damping >= 0.0 &&
                       mechanism.stopStiffness > 0.0 && mechanism.stopDamping >= 0.0 &&
                       mechanism.resolution >= 0.0 && mechanism.inertia >= 0.0 &&
                       mechanism.rotationalStiffness >= 0.0 && mechanism.rotationalDamping >= 0.0 &&
                       capabilities_.largestTravel > capabilities_.leastTravel;
  if (!isSound) throw std::invalid_argument("a simulated mechanism needs a mass and a range");
  travel_ = capabilities_.leastTravel;
}

SimulatedDevice::SimulatedDevice(const DeviceKind& kind, Hand& hand)
    : SimulatedDevice(simulated(kind), kind.mechanism, hand) {}

double SimulatedDevice::stopForce() const noexcept {
  const double beyond = travel_ > capabilities_.largestTravel
                            ? travel_ - capabilities_.largestTravel
                        : travel_ < capabilities_.leastTravel ? travel_ - capabilities_.leastTravel
                                                              : 0.0;
  if (beyond == 0.0) return 0.0;
  const double force = mechanism_.stopStiffness * beyond + mechanism_.stopDamping * velocity_;
  return force * beyond > 0.0 ? force : 0.0;  // a stop pushes, but never pulls
}

void SimulatedDevice::turn(double dt) noexcept {
  if (!(mechanism_.inertia > 0.0)) return;
  const double net = torque_ - mechanism_.rotationalDamping * angularVelocity_ -
                     mechanism_.rotationalStiffness * turn_;
  angularVelocity_ += dt * net / mechanism_.inertia;
  turn_ += dt * angularVelocity_;
  if (std::isfinite(turn_) && std::isfinite(angularVelocity_)) return;
  turn_ = 0.0;
  angularVelocity_ = 0.0;
}

DeviceSample SimulatedDevice::read(double dt) noexcept {
  const double push = hand_.push(travel_, velocity_, dt);
  const double net = push - force_ - mechanism_.damping * velocity_ - stopForce();
  velocity_ += dt * net / mechanism_.mass;
  travel_ += dt * velocity_;
  turn(dt);
  if (!std::isfinite(travel_) || !std::isfinite(velocity_)) {
    travel_ = capabilities_.leastTravel;
    velocity_ = 0.0;
    return {.status = DeviceStatus::Faulted};
  }
  if (isGone_.load(std::memory_order_relaxed)) return {.status = DeviceStatus::NotAnswering};

  const double resolution = mechanism_.resolution;
  const double seen = resolution > 0.0 ? resolution * std::round(travel_ / resolution) : travel_;
  return {
      .status = DeviceStatus::Ok,
      .travel = seen,
      .velocity = velocity_,
      .turn = turn_,
      .isDeadManHeld = isDeadManHeld_.load(std::memory_order_relaxed),
      .isReamerOn = isReamerOn_.load(std::memory_order_relaxed)};
}

Capabilities simulated(const DeviceKind& kind) {
  return {
      .kind = &kind,
      .name = "simulated " + std::string(kind.name),
      .leastTravel = kind.travel.least,
      .largestTravel = kind.travel.most,
      .maxForce = kind.simulatedMaxForce,
      .maxTorque = kind.simulatedMaxTorque,
      .damping = kind.mechanism.damping};
}

}  // namespace haptics::devices
