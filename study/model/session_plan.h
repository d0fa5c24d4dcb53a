#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocols/model/loaded_protocol.h"
#include "protocols/orders/schedule.h"

namespace study {

/// What happens in a step.
enum class StepKind {
  Reading,  ///< information, debrief
  Consent,
  Form,
  Benchmark,      ///< cuts with the physical tool
  Trial,          ///< a condition is rendered
  Questionnaire,  ///< about the condition just rendered
  Preference,
  Break,
  Interview,  ///< for the operator
};

std::string_view nameOf(StepKind kind) noexcept;
std::optional<StepKind> stepKindNamed(std::string_view name) noexcept;

/// One step of a session; a session is a list of steps.
struct Step {
  StepKind kind = StepKind::Reading;
  std::string phase;
  std::string instrument;  ///< shown or asked; empty for trials, benchmarks, breaks
  std::string itemSet;
  int position = 0;              ///< Trial, Questionnaire: position in its block, from 1
  int label = 0;                 ///< Trial, Questionnaire: the label of the alternative, from 1
  std::string condition;         ///< Trial, Questionnaire: its id; participants never see it
  bool isVisualised = false;     ///< Trial: whether the simulated scene is shown
  int minimumCuts = 0;           ///< Trial, Benchmark: smallest number of cuts or strokes
  bool isOptionalTrial = false;  ///< Trial: an optional repetition before a preference
  double seconds = 0.0;          ///< Break: minimum duration [s]
  std::vector<std::string> alternatives;  ///< Preference: the labels to choose from

  bool hasItems() const noexcept { return !instrument.empty(); }
};

/// All steps of a session, in order.
std::vector<Step> sessionPlan(
    const protocols::Protocol& protocol, const protocols::Schedule& schedule);

}  // namespace study
