#pragma once

#include <memory>

#include "study/session/session.h"
#include "study/trial/rig.h"
#include "study/trial/trial.h"

namespace study {

/// The device that the trial @p session stands before is felt on.
const protocols::DeviceNeed& deviceFor(const Session& session);

/// That trial as it is to be rendered, and kept by @p keep.
Trial::Setup setupFor(const Session& session, Trial::Keep keep);

/// That trial on its device of @p rig, open and armed.
/// @throws UserError, haptics::devices::DeviceError  if the device is not there or not ready.
std::unique_ptr<Trial> trialFor(const Session& session, Rig& rig, Trial::Keep keep);

}  // namespace study
