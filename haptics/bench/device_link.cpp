#include "haptics/bench/device_link.h"

#include <sys/resource.h>

#include <cmath>

#include "haptics/engine/built_in_models.h"
#include "haptics/timing/monotonic_clock.h"

namespace haptics::bench {
namespace {

engine::SafetyLimits limitsFor(const devices::Capabilities& device) {
  const bool isBone = device.kind->tissue == devices::Tissue::Bone;
  return {.maxForce = device.maxForce, .maxRate = isBone ? 5000.0 : 300.0};
}

/// Processor time of this process, all threads [s].
double processorTime() noexcept {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace

engine::SceneSpec sceneForLink(devices::Tissue tissue) {
  if (tissue == devices::Tissue::Meniscus) return {.model = engine::publishedElements(5)};
  engine::MaterialSpec material;
  material.nodes = engine::parametricMaterial();
  material.hardness = 1.0;
  material.forceScale = 0.15;
  return {.model = material};
}

LinkLoop::LinkLoop(devices::Device& device)
    : device_(device),
      leastStallForce_(0.05 * device.capabilities().maxForce),
      scene_(sceneForLink(device.capabilities().kind->tissue)),
      engine_(device, limitsFor(device.capabilities())) {
  engine_.setScene(&scene_);
  device_.arm();
  processorBefore_ = processorTime();
  begin_ = timing::now();
  loop_.emplace(
      engine::RealtimeLoop::Options{.rate = device.capabilities().rate, .pacer = device.pacer()},
      [this](double dt, double lateness) { tick(dt, lateness); });
}

LinkLoop::~LinkLoop() {
  if (loop_) finish();
}

void LinkLoop::orderStall(std::int64_t duration) noexcept {
  stalledAt_.store(0, std::memory_order_relaxed);
  orderedAt_.store(timing::now(), std::memory_order_relaxed);
  stallDuration_.store(duration, std::memory_order_release);
}

bool LinkLoop::isStallDue(double force) noexcept {
  constexpr std::int64_t kPatience = 3 * timing::kSecond;
  if (stallDuration_.load(std::memory_order_acquire) == 0) return false;
  const bool falls = std::abs(force) < std::abs(lastForce_);
  return (falls && std::abs(force) >= leastStallForce_) ||
         timing::now() - orderedAt_.load(std::memory_order_relaxed) > kPatience;
}

void LinkLoop::tick(double dt, double lateness) noexcept {
  const auto missedPeriods = static_cast<int>(1e-6 * lateness / dt);
  const auto sample = engine_.tick(dt, missedPeriods);
  if (isOver()) return;
  ++run_.ticks;
  run_.missedPeriods += static_cast<std::uint64_t>(missedPeriods);
  run_.seconds = 1e-9 * static_cast<double>(timing::now() - begin_);
  using Status = devices::DeviceStatus;
  if (sample.status == Status::NotAnswering || sample.status == Status::Faulted) {
    isOver_.store(true, std::memory_order_release);
    return;
  }
  const bool pauses = isStallDue(sample.force);
  lastForce_ = sample.force;
  if (!pauses) return;
  const std::int64_t now = timing::now();
  stalledAt_.store(now, std::memory_order_release);
  timing::sleepUntil(now + stallDuration_.exchange(0, std::memory_order_relaxed));
}

LinkRun LinkLoop::finish() {
  run_.loop = loop_->finish();
  run_.isRealtime = loop_->isRealtime();
  loop_.reset();
  run_.processor = processorTime() - processorBefore_;
  // Reads the counts before disarming: afterwards the device's keep-alive thread changes them.
  run_.link = device_.link();
  run_.fault = base::describe(device_.fault());
  device_.disarm();
  return run_;
}

}  // namespace haptics::bench
