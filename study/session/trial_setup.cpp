#include "study/session/trial_setup.h"

#include <utility>

namespace study {

const protocols::DeviceNeed& deviceFor(const Session& session) {
  const auto& protocol = session.protocol().protocol;
  return *protocol.device(protocol.condition(session.step().condition)->device);
}

Trial::Setup setupFor(const Session& session, Trial::Keep keep) {
  const auto& need = deviceFor(session);
  auto scene = session.protocol().protocol.condition(session.step().condition)->scene;
  scene.isVisualised = session.step().isVisualised;
  return {
      .scene = std::move(scene),
      .limits =
          {.maxForce = need.maxForce,
           .maxRate = need.maxForceRate,
           .maxVelocity = need.maxVelocity,
           .isPassivityControlled = need.isPassivityControlled},
      .keep = std::move(keep)};
}

std::unique_ptr<Trial> trialFor(const Session& session, Rig& rig, Trial::Keep keep) {
  const auto& need = deviceFor(session);
  auto setup = setupFor(session, std::move(keep));
  auto& device = rig.device(need);
  rig.prepare(need, setup.scene);
  return std::make_unique<Trial>(device, std::move(setup));
}

}  // namespace study
