#pragma once

#include "protocols/model/protocol.h"
#include "questionnaires/json/document.h"

namespace protocols {

/// Reads the analysis plan (docs/protocol-format.md, "The analysis plan"); problems go where the
/// node's go.
AnalysisPlan readAnalysis(const questionnaires::Node& node);

/// Reads what a simulated cohort feels ("Trying it out").
SimulationTruth readSimulation(const questionnaires::Node& node);

}  // namespace protocols
