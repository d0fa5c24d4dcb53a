#pragma once

#include <memory>

#include "study/session/session.h"
#include "study/storage/trace_store.h"
#include "study/trial/device_set.h"
#include "study/trial/trial.h"

namespace study {

/// The device that the protocol asks for in the present trial of @p session.
const protocols::DeviceNeed& deviceFor(const Session& session);

/// The scene of that trial: what is rendered and shown.
haptics::engine::SceneSpec sceneFor(const Session& session);

/// The setup of that trial. Its samples are stored in @p traces, which must outlive it.
Trial::Setup setupFor(const Session& session, storage::TraceStore& traces);

/// That trial, with its device of @p deviceSet opened and armed.
/// @throws UserError, haptics::devices::DeviceError  if the device is missing or not ready.
std::unique_ptr<Trial> trialFor(
    const Session& session, DeviceSet& deviceSet, storage::TraceStore& traces);

}  // namespace study
