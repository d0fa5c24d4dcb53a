#pragma once

#include <string>
#include <vector>

#include "study/cohort/simulated_participant.h"

namespace study::app {

/// The number of completed sessions.
int countCompleted(const std::vector<SimulatedSessionResult>& endings) noexcept;

/// Describes a session that was not completed: "SIM-001 ended as aborted_hardware at step 3 after 5
/// attempts: the motor's driver reports a fault. Trials finished: 0 of 5."
std::string describe(const SimulatedSessionResult& ending);

/// Describes the sessions that were not completed, for the end of a sentence: ", 1 ended as
/// aborted_hardware (SIM-001 at step 3: …)"; empty if all were completed.
std::string describeIncomplete(const std::vector<SimulatedSessionResult>& endings);

}  // namespace study::app
