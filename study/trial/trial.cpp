#include "study/trial/trial.h"

#include <exception>
#include <utility>

namespace study {
namespace {

using haptics::devices::DeviceStatus;
using haptics::engine::TickSample;

storage::TraceSample asTrace(const TickSample& sample) {
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

}  // namespace

Trial::Trial(haptics::devices::Device& device, Setup setup)
    : device_(device),
      scene_(setup.scene),
      slope_(haptics::engine::renderedSlope(
          setup.scene, *device.capabilities().kind, device.capabilities().rate)),
      engine_(device, setup.limits),
      keep_(std::move(setup.keep)),
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
  chunk_.push_back(asTrace(sample));
  if (static_cast<double>(chunk_.size()) >= rate()) keepChunk();
}

void Trial::keepChunk() {
  if (chunk_.empty()) return;
  keep_(chunks_, chunk_);
  kept_ += static_cast<std::int64_t>(chunk_.size());
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
      .deviceFault = fault};
  try {
    keepChunk();
  } catch (const std::exception&) {
    record.ending = TrialEnding::TraceLost;
  }
  statistics_.fillIn(record);
  record.traceSamples = kept_;
  return record;
}

TrialRecord runOffline(Trial& trial, int cuts, double longest) {
  const double dt = 1.0 / trial.rate();
  const auto most = static_cast<std::int64_t>(longest * trial.rate());
  try {
    for (std::int64_t i = 0; i < most; ++i) {
      const auto sample = trial.step(dt);
      trial.keep(sample);
      if (sample.status == DeviceStatus::Gone || sample.status == DeviceStatus::Faulted) {
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
