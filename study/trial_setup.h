#pragma once

#include "study/session.h"
#include "study/trial.h"

namespace study {

/// The device that the trial @p session stands before is felt on.
const protocols::DeviceNeed& deviceFor(const Session& session);

/// That trial as it is to be rendered, and kept by @p keep.
Trial::Setup setupFor(const Session& session, Trial::Keep keep);

}  // namespace study
