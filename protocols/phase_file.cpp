#include "protocols/phase_file.h"

#include <array>

#include "protocols/localized_file.h"

namespace protocols {
namespace {

using questionnaires::Choice;
using questionnaires::Node;

constexpr std::array kPhaseTypes{
    Choice<PhaseType>{"information", PhaseType::Information},
    Choice<PhaseType>{"consent", PhaseType::Consent},
    Choice<PhaseType>{"form", PhaseType::Form},
    Choice<PhaseType>{"benchmark", PhaseType::Benchmark},
    Choice<PhaseType>{"block", PhaseType::Block},
    Choice<PhaseType>{"preference", PhaseType::Preference},
    Choice<PhaseType>{"break", PhaseType::Break},
    Choice<PhaseType>{"interview", PhaseType::Interview},
    Choice<PhaseType>{"debrief", PhaseType::Debrief},
};
constexpr std::array kOrders{
    Choice<OrderType>{"fixed", OrderType::Fixed},
    Choice<OrderType>{"reversed", OrderType::Reversed},
    Choice<OrderType>{"random", OrderType::Random},
    Choice<OrderType>{"latinSquare", OrderType::LatinSquare},
    Choice<OrderType>{"balancedLatinSquare", OrderType::BalancedLatinSquare},
    Choice<OrderType>{"complete", OrderType::Complete},
};
constexpr int kMostCuts = 1000;

Order readOrder(const Node& block) {
  Order order;
  const auto node = block.requiredObject("order");
  if (!node || !node->isObjectWith({"type", "of"})) return order;
  order.type = node->choice("type", kOrders);
  if (order.type == OrderType::Reversed) {
    order.of = node->id("of");
  } else if (node->has("of")) {
    node->problem("of", "only a reversed order is 'of' another block", "remove it");
  }
  return order;
}

std::vector<ConditionQuestionnaire> readQuestionnaires(const Node& block) {
  std::vector<ConditionQuestionnaire> all;
  for (const auto& node : block.list("questionnaires")) {
    if (!node.isObjectWith({"instrument", "set_by_condition"})) continue;
    ConditionQuestionnaire questionnaire{.instrument = node.id("instrument"), .setByCondition = {}};
    if (const auto sets = node.object("set_by_condition")) {
      for (const auto& [condition, set] : sets->members()) {
        questionnaire.setByCondition.emplace_back(condition, set.asText());
      }
    }
    all.push_back(std::move(questionnaire));
  }
  return all;
}

void readBlock(const Node& node, Phase& phase) {
  if (!node.isObjectWith(
          {"id",
           "type",
           "conditions",
           "visualisation",
           "order",
           "minimum_cuts",
           "questionnaires"})) {
    return;
  }
  auto& block = phase.trials;
  block.conditions = node.ids("conditions");
  if (block.conditions.empty()) {
    node.problem("", "this block has no conditions", "add 'conditions': [\"…\"]");
  }
  if (node.has("visualisation")) block.isVisualised = node.flag("visualisation", false);
  block.order = readOrder(node);
  block.minimumCuts = static_cast<int>(node.wholeNumber("minimum_cuts", 1, kMostCuts));
  block.questionnaires = readQuestionnaires(node);
}

void readBenchmark(const Node& node, Phase& phase) {
  if (!node.isObjectWith({"id", "type", "text", "minimum_cuts"})) return;
  phase.text = readLocalized(node, "text");
  phase.minimumCuts = static_cast<int>(node.wholeNumber("minimum_cuts", 1, kMostCuts));
}

void readBreak(const Node& node, Phase& phase) {
  if (!node.isObjectWith({"id", "type", "text", "seconds"})) return;
  phase.text = readLocalized(node, "text");
  phase.seconds = node.number("seconds", 0.0, 86'400.0);
}

void readPreference(const Node& node, Phase& phase) {
  if (!node.isObjectWith({"id", "type", "instrument", "block"})) return;
  phase.instrument = node.id("instrument");
  phase.block = node.id("block");
}

void readWithInstrument(const Node& node, Phase& phase) {
  if (node.isObjectWith({"id", "type", "instrument"})) phase.instrument = node.id("instrument");
}

}  // namespace

Phase readPhase(const Node& node) {
  Phase phase;
  if (!node.isObject()) {
    node.isObjectWith({});
    return phase;
  }
  phase.id = node.id("id");
  phase.type = node.choice("type", kPhaseTypes);
  switch (phase.type) {
    case PhaseType::Block:
      readBlock(node, phase);
      break;
    case PhaseType::Benchmark:
      readBenchmark(node, phase);
      break;
    case PhaseType::Break:
      readBreak(node, phase);
      break;
    case PhaseType::Preference:
      readPreference(node, phase);
      break;
    default:
      readWithInstrument(node, phase);
  }
  return phase;
}

}  // namespace protocols
