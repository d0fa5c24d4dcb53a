#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "protocols/model/protocol.h"
#include "questionnaires/json/document.h"
#include "questionnaires/model/instrument.h"

/// The parts of a protocol file, each read by a source of its own.
namespace protocols {

class SceneSources;

/// A text that people see, in English at least: "…" or {"en": "…", "de": "…"}. Missing or wrong is
/// a problem.
questionnaires::LocalizedText readLocalized(const questionnaires::Node& node, std::string_view key);

/// What the word behind @p key stands for; nothing, and a problem, where it is none of @p choices:
/// for words that decide what else is read.
template <typename Choices>
auto readChoice(const questionnaires::Node& node, std::string_view key, const Choices& choices) {
  const auto value = node.choice(key, choices);
  const auto written = node.member(key);
  const bool isKnown = written && written->isText() &&
                       std::any_of(choices.begin(), choices.end(), [&](const auto& choice) {
                         return choice.name == written->asText();
                       });
  return isKnown ? std::optional(value) : std::nullopt;
}

/// Reads one phase (docs/protocol-format.md, "Phases"); problems go where the node's go. One whose
/// type is not understood has no id.
Phase readPhase(const questionnaires::Node& node);

/// Reads what is felt and seen in a condition (docs/protocol-format.md, "Scenes") into @p
/// condition, with what the scene's files hold, from @p sources; problems go where the node's go.
/// @param protocol  its devices have been read.
void readScene(
    const questionnaires::Node& scene,
    const Protocol& protocol,
    SceneSources& sources,
    Condition& condition);

/// Reads the analysis plan (docs/protocol-format.md, "The analysis plan"); problems go where the
/// node's go.
AnalysisPlan readAnalysis(const questionnaires::Node& node);

/// Reads what a simulated cohort feels ("Trying it out").
SimulationTruth readSimulation(const questionnaires::Node& node);

}  // namespace protocols
