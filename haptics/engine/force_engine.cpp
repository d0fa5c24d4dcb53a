#include "haptics/engine/force_engine.h"

#include <cmath>

namespace haptics::engine {

CutDetector::Parameters cutParametersFor(devices::DeviceKind kind) noexcept {
  if (kind == devices::DeviceKind::Punch) return {};
  CutDetector::Parameters stroke;
  stroke.closedAbove = 0.008;  // [m]: well into the bone
  stroke.openBelow = 0.002;
  stroke.contactForce = 1.0;
  stroke.creep = 0.0;
  stroke.yieldDrop = 1.0;
  stroke.advance = 0.0003;
  stroke.bottomAbove = 0.018;
  stroke.bottomRise = 2.0;
  stroke.retreat = 0.001;
  return stroke;
}

ForceEngine::ForceEngine(devices::Device& device, const ForceLimiter::Limits& limits)
    : device_(device), limiter_(limits), cuts_(cutParametersFor(device.capabilities().kind)) {}

void ForceEngine::setScene(CompiledScene* scene) noexcept {
  scene_.store(scene, std::memory_order_release);
}

TickSample ForceEngine::tick(double dt) noexcept {
  TickSample sample;
  sample.tick = ticks_++;
  const devices::DeviceSample seen = device_.read(dt);
  sample.status = seen.status;
  const bool isNumber = std::isfinite(seen.travel) && std::isfinite(seen.velocity);
  if (seen.status == devices::DeviceStatus::Ok && isNumber) {
    tool_ = {.travel = seen.travel, .velocity = seen.velocity};
  } else {
    sample.marks |= TickSample::Invalid;
    const bool isFault = seen.status != devices::DeviceStatus::Ok &&
                         seen.status != devices::DeviceStatus::Stale;
    if (isFault) stop();  // until the operator has decided
  }
  sample.travel = tool_.travel;
  sample.velocity = tool_.velocity;

  CompiledScene* scene = scene_.load(std::memory_order_acquire);
  if (scene != felt_) {
    felt_ = scene;
    cuts_.reset();
    if (scene != nullptr) scene->reset();
  }
  if (scene == nullptr) sample.marks |= TickSample::Bare;
  if (isStopped()) sample.marks |= TickSample::Stopped;

  constexpr int kLetGo = TickSample::Invalid | TickSample::Stopped;
  if ((sample.marks & kLetGo) != 0) {
    limiter_.release();
  } else {
    if (scene != nullptr) sample.desired = desiredForce(*scene, sample);
    const auto limited = limiter_.limit(sample.desired, dt);
    sample.force = limited.force;
    sample.interventions = limited.interventions;
  }
  device_.command(sample.force);
  followCuts(sample);
  return sample;
}

double ForceEngine::desiredForce(CompiledScene& scene, TickSample& sample) noexcept {
  const auto response = scene.respond(tool_);
  if (!response.isDefined) sample.marks |= TickSample::Undefined;
  return response.isDefined ? response.force : 0.0;
}

void ForceEngine::followCuts(TickSample& sample) noexcept {
  if (felt_ != nullptr && (sample.marks & (TickSample::Invalid | TickSample::Stopped)) == 0) {
    sample.landmark = cuts_.feed(sample.travel, sample.force);
  }
  sample.cuts = cuts_.completedCuts();
}

}  // namespace haptics::engine
