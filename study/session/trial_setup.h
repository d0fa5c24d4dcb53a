#pragma once

#include <memory>

#include "study/session/session.h"
#include "study/storage/trace_store.h"
#include "study/trial/device_set.h"
#include "study/trial/trial.h"

namespace study {

/// The device that the protocol names for the present trial of @p session.
const protocols::DeviceRequirement& deviceFor(const Session& session);

/// The scene that the present trial renders and shows.
haptics::engine::SceneSpec sceneFor(const Session& session);

/// Moves the pointer's hand on the device of the present trial; does nothing in other steps.
void moveHand(const Session& session, PointerHands& hands, double share);

/// The limits that a protocol sets for a device.
haptics::engine::SafetyLimits limitsOf(const protocols::DeviceRequirement& need);

/// The setup of the present trial. Its samples are stored in @p traces, which must outlive the
/// trial.
Trial::Setup setupFor(const Session& session, storage::TraceStore& traces);

/// The present trial, with its device of @p deviceSet opened and armed.
/// @throws UserError, haptics::devices::DeviceError  if the device is missing or not ready.
std::unique_ptr<Trial> trialFor(
    const Session& session, DeviceSet& deviceSet, storage::TraceStore& traces);

}  // namespace study
