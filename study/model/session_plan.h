#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocols/model/loaded_protocol.h"
#include "protocols/orders/schedule.h"

namespace study {

enum class StepKind {
  Reading,  ///< information, debrief
  Consent,
  Form,
  Benchmark,      ///< cuts on the physical tool
  Trial,          ///< something is felt
  Questionnaire,  ///< about what was just felt
  Preference,
  Break,
  Interview,  ///< for the operator
};

std::string_view nameOf(StepKind kind) noexcept;
std::optional<StepKind> stepKindNamed(std::string_view name) noexcept;

/// One thing that a participant does. A session is a list of them.
struct Step {
  StepKind kind = StepKind::Reading;
  std::string phase;
  std::string instrument;  ///< what is shown or asked; empty for trials, benchmarks, breaks
  std::string itemSet;
  int position = 0;           ///< Trial, Questionnaire: in its block, from 1
  int label = 0;              ///< … and which alternative, from 1
  std::string condition;      ///< … and what that is. For the engine and the analyst; nobody else
  bool isVisualised = false;  ///< Trial
  int minimumCuts = 0;        ///< Trial, Benchmark
  bool isOffered = false;     ///< Trial: once more, before a preference; may be declined
  double seconds = 0.0;       ///< Break: at least [s]
  std::vector<std::string> alternatives;  ///< Preference: the labels to choose from

  bool hasItems() const noexcept { return !instrument.empty(); }
};

/// All steps of a session, in order.
std::vector<Step> sessionPlan(
    const protocols::Protocol& protocol, const protocols::Schedule& schedule);

}  // namespace study
