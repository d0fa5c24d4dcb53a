#pragma once

#include <string_view>

#include "protocols/model/protocol.h"
#include "questionnaires/json/document.h"
#include "questionnaires/model/instrument.h"

/// Functions that read the parts of a protocol file. Each is in its own source file.
namespace protocols {

class SceneSources;

/// Reads a localized text, which must have at least English: "…" or {"en": "…", "de": "…"}. A
/// missing or invalid text is a problem.
questionnaires::LocalizedText readLocalized(const questionnaires::Node& node, std::string_view key);

/// Reads one phase (docs/protocol-format.md, "Phases"). Problems are added to the list of @p node.
/// A phase of unknown type has no id.
Phase readPhase(const questionnaires::Node& node);

/// Reads the scene of a condition (docs/protocol-format.md, "Scenes") into @p condition, with the
/// content of its files from @p sources. Problems are added to the list of @p scene.
void readScene(const questionnaires::Node& scene, SceneSources& sources, Condition& condition);

/// Reads the analysis plan (docs/protocol-format.md, "The analysis plan"). Problems are added to
/// the list of @p node.
AnalysisPlan readAnalysis(const questionnaires::Node& node);

/// Reads the parameters of simulated answers (docs/protocol-format.md, "Simulated participants").
SimulatedAnswerModel readSimulation(const questionnaires::Node& node);

}  // namespace protocols
