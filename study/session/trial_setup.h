#pragma once

#include <memory>

#include "study/session/session.h"
#include "study/storage/trace_store.h"
#include "study/trial/device_set.h"
#include "study/trial/trial.h"

namespace study {

/// The device that the trial @p session stands before is felt on.
const protocols::DeviceNeed& deviceFor(const Session& session);

/// What is felt and seen in that trial.
haptics::engine::SceneSpec sceneFor(const Session& session);

/// That trial as it is to be rendered, its samples kept in @p traces, which outlives it.
Trial::Setup setupFor(const Session& session, storage::TraceStore& traces);

/// That trial on its device of @p deviceSet, open and armed.
/// @throws UserError, haptics::devices::DeviceError  if the device is not there or not ready.
std::unique_ptr<Trial> trialFor(
    const Session& session, DeviceSet& deviceSet, storage::TraceStore& traces);

}  // namespace study
