#include "study/session/trial_setup.h"

#include <utility>

namespace study {

const protocols::DeviceRequirement& deviceFor(const Session& session) {
  const auto& protocol = session.protocol().protocol;
  return *protocol.device(protocol.condition(session.step().condition)->device);
}

haptics::engine::SceneSpec sceneFor(const Session& session) {
  auto scene = session.protocol().protocol.condition(session.step().condition)->scene();
  scene.isVisualised = session.step().isVisualised;
  return scene;
}

void moveHand(const Session& session, PointerHands& hands, double share) {
  if (session.isOver() || session.step().kind != StepKind::Trial) return;
  hands.moveTo(deviceFor(session), share);
}

haptics::engine::SafetyLimits limitsOf(const protocols::DeviceRequirement& need) {
  return {
      .maxForce = need.maxForce,
      .maxRate = need.maxForceRate,
      .maxTorque = need.maxTorque,
      .maxTorqueRate = need.maxTorqueRate,
      .maxVelocity = need.maxVelocity,
      .isPassivityControlled = need.isPassivityControlled};
}

Trial::Setup setupFor(const Session& session, storage::TraceStore& traces) {
  using Sealing = storage::TraceStore::Sealing;
  const auto& need = deviceFor(session);
  const auto sealing =
      session.runMode() == RunMode::Simulated ? Sealing::Never : Sealing::IfThereIsAKey;
  return {
      .scene = sceneFor(session),
      .limits = limitsOf(need),
      .storeChunk = [&traces, visit = session.visit(), sealing](
                        int number,
                        const auto& samples) { traces.add(visit, number, samples, sealing); },
      .needsDevice = session.runMode() == RunMode::Live};
}

std::unique_ptr<Trial> trialFor(
    const Session& session, DeviceSet& deviceSet, storage::TraceStore& traces) {
  const auto& need = deviceFor(session);
  auto setup = setupFor(session, traces);
  auto& device = deviceSet.device(need);
  deviceSet.prepare(need, setup.scene);
  return std::make_unique<Trial>(device, std::move(setup));
}

}  // namespace study
