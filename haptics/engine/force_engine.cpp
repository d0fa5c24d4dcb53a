#include "haptics/engine/force_engine.h"

#include <cmath>
#include <stdexcept>

namespace haptics::engine {
namespace {

const SafetyLimits& validated(const SafetyLimits& limits) {
  const bool isSound = limits.maxVelocity > 0.0 && limits.rampTime > 0.0 &&
                       std::isfinite(limits.rampTime) && limits.softStartShare > 0.0 &&
                       limits.softStartShare <= 1.0 && limits.longestSilence > 0.0;
  if (!isSound) throw std::invalid_argument("a limit of velocity or time must be above 0");
  return limits;
}

/// The tolerance, which covers rounding, is 1e-4 of the largest force times the range of travel.
/// The controller adds at most four times the mechanism's damping.
EnergyObserver::Settings energySettings(
    const devices::Capabilities& device, const SafetyLimits& limits) {
  const double range = device.largestTravel - device.leastTravel;
  return {
      .deviceDamping = device.damping,
      .tolerance = 1e-4 * limits.maxForce * range,
      .mostDamping = limits.isPassivityControlled ? 4.0 * device.damping : 0.0,
      .leastVelocity = 1e-6 * range};  // below, dividing by the velocity gives only rounding errors
}

/// A driven reamer does work on a hand that yields to its torque: the energy is observed, but not
/// damped. The tolerance covers rounding, over a rotation of one radian.
EnergyObserver::Settings rotationEnergySettings(const SafetyLimits& limits) {
  return {.tolerance = 1e-4 * limits.maxTorque};
}

std::uint8_t marksOf(std::uint8_t reasons, bool hasScene) noexcept {
  std::uint8_t marks = TickSample::None;
  if ((reasons & ForceGate::TooFast) != 0) marks |= TickSample::TooFast;
  if ((reasons & ForceGate::DeadManReleased) != 0) marks |= TickSample::DeadManReleased;
  if ((reasons & ForceGate::MissedPeriods) != 0) marks |= TickSample::MissedPeriods;
  if ((reasons & ForceGate::SoftStart) != 0 && hasScene) marks |= TickSample::SoftStart;
  return marks;
}

}  // namespace

ForceEngine::ForceEngine(devices::Device& device, const SafetyLimits& limits)
    : device_(device),
      limiter_(limits),
      torqueLimiter_(ForceLimiter::forTorque(limits)),
      gate_(validated(limits)),
      energy_(energySettings(device.capabilities(), limits)),
      rotationEnergy_(rotationEnergySettings(limits)),
      cuts_(device.capabilities().kind->stroke) {}

void ForceEngine::setScene(CompiledScene* scene) noexcept {
  scene_.store(scene, std::memory_order_release);
}

/// Reads the device. Returns whether there is a new sample. If not, @p sample gets the last travel
/// and velocity, and its status says why.
bool ForceEngine::read(TickSample& sample, double dt) noexcept {
  const devices::DeviceSample seen = device_.read(dt);
  sample.status = seen.status;
  sample.leaps = seen.leaps;
  const bool isNumber =
      std::isfinite(seen.travel) && std::isfinite(seen.velocity) && std::isfinite(seen.turn);
  const bool isMeasured = seen.status == devices::DeviceStatus::Ok && isNumber;
  travelChange_ = isMeasured && hasMeasuredTool_ ? seen.travel - tool_.travel : 0.0;
  turnChange_ = isMeasured && hasMeasuredTool_ ? seen.turn - turn_ : 0.0;
  if (isMeasured) {
    turn_ = seen.turn;
    tool_ = {
        .travel = seen.travel,
        .velocity = seen.velocity,
        .dt = dt,
        .isReamerOn = seen.isReamerOn && isReamerOn_.load(std::memory_order_relaxed)};
    hasMeasuredTool_ = true;
    isDeadManHeld_ = seen.isDeadManHeld;
  } else {
    sample.marks |= TickSample::Invalid;
    const bool isFault = seen.status == devices::DeviceStatus::NotAnswering ||
                         seen.status == devices::DeviceStatus::Faulted;
    if (isFault) stop();  // until the operator arms the engine again
  }
  sample.travel = tool_.travel;
  sample.velocity = tool_.velocity;
  return isMeasured;
}

void ForceEngine::adoptScene() noexcept {
  CompiledScene* scene = scene_.load(std::memory_order_acquire);
  if (scene == lastScene_) return;
  lastScene_ = scene;
  cuts_.reset();
  gate_.startSoftly();
  energy_.reset();
  rotationEnergy_.reset();
  if (scene != nullptr) scene->reset();
}

TickSample ForceEngine::tick(double dt, int missedPeriods) noexcept {
  TickSample sample;
  sample.tick = ticks_++;
  const bool isMeasured = read(sample, dt);
  adoptScene();
  if (lastScene_ == nullptr) sample.marks |= TickSample::NoScene;
  if (isStopped()) {
    sample.marks |= TickSample::Stopped;
    gate_.close();
    limiter_.release();
    torqueLimiter_.release();
    energy_.reset();
    rotationEnergy_.reset();
  } else {
    render(
        sample,
        {.isMeasured = isMeasured,
         .isDeadManHeld = isDeadManHeld_,
         .velocity = tool_.velocity,
         .missedPeriods = missedPeriods},
        dt);
  }
  device_.command(sample.force, sample.torque);
  commanded_ = sample.force;
  commandedTorque_ = sample.torque;
  detectLandmarks(sample);
  return sample;
}

void ForceEngine::render(TickSample& sample, const ForceGate::Input& input, double dt) noexcept {
  if (input.isMeasured) {
    // Work of the last step: the force commanded in the last tick times the motion since.
    energy_.observe(commanded_, travelChange_, tool_.velocity, dt);
    // The torque does work on the hand; the scene takes up the negative of that work.
    rotationEnergy_.observe(-commandedTorque_, turnChange_, turnChange_ / dt, dt);
    desired_ = lastScene_ != nullptr ? desiredForce(sample) : 0.0;
    const bool isDefined = (sample.marks & TickSample::Undefined) == 0;
    desiredTorque_ = lastScene_ != nullptr && isDefined ? lastScene_->torque() : 0.0;
  }
  sample.desired = desired_;
  sample.energy = energy_.energy();
  const double passive = energy_.damped(desired_, tool_.velocity, dt);

  auto gateInput = input;
  gateInput.desired = desired_;
  const auto gate = gate_.step(gateInput, dt);
  // The limiter comes last, so it also limits the output of the passivity controller and of the
  // gate.
  const auto limited = limiter_.limit(passive * gate.gain, dt);
  sample.force = limited.force;
  sample.interventions = limited.interventions;
  if (energy_.isActive()) sample.interventions |= ForceLimiter::Active;
  if (passive != desired_) sample.interventions |= ForceLimiter::Damped;
  renderTorque(sample, gate.gain, dt);
  sample.marks |= marksOf(gate.reasons, lastScene_ != nullptr);
  if (gate.isSilenceTooLong) stop();
}

void ForceEngine::renderTorque(TickSample& sample, double gain, double dt) noexcept {
  sample.desiredTorque = desiredTorque_;
  sample.rotationEnergy = rotationEnergy_.energy();
  if (!device_.capabilities().rendersTorque()) return;
  const auto limited = torqueLimiter_.limit(desiredTorque_ * gain, dt);
  sample.torque = limited.force;
  sample.interventions |= limited.interventions;
  if (rotationEnergy_.isActive()) sample.interventions |= ForceLimiter::TorqueActive;
}

double ForceEngine::desiredForce(TickSample& sample) noexcept {
  const auto response = lastScene_->respond(tool_);
  if (!response.isDefined) sample.marks |= TickSample::Undefined;
  return response.isDefined ? response.force : 0.0;
}

void ForceEngine::detectLandmarks(TickSample& sample) noexcept {
  if (lastScene_ != nullptr && (sample.marks & (TickSample::Invalid | TickSample::Stopped)) == 0) {
    const bool isSettling = (sample.marks & TickSample::SoftStart) != 0;
    sample.landmark = cuts_.feed(sample.travel, sample.force, isSettling);
  }
  sample.cuts = cuts_.completedCuts();
}

}  // namespace haptics::engine
