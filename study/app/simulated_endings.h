#pragma once

#include <string>
#include <vector>

#include "study/cohort/simulated_participant.h"

namespace study::app {

/// How many came to the end of their session.
int completedOf(const std::vector<SimulatedEnding>& endings) noexcept;

/// Of one whose session ended otherwise: "SIM-001 ended as aborted_hardware at step 3 after 5
/// attempts: the motor's driver reports a fault. Trials finished: 0 of 5."
std::string describe(const SimulatedEnding& ending);

/// Behind the number of those who have finished: ", 1 ended as aborted_hardware (SIM-001 at step 3:
/// …)"; empty where all have.
std::string othersInWords(const std::vector<SimulatedEnding>& endings);

}  // namespace study::app
