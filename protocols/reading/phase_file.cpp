#include <array>

#include "protocols/orders/schedule.h"
#include "protocols/reading/protocol_parts.h"

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
  // if the type cannot be read, Random stays, because no rule refuses it
  Order order{.type = OrderType::Random, .of = {}};
  const auto node = block.requiredObject("order");
  if (!node || !node->isObjectWithOnlyKeys({"type", "of"})) return order;
  const auto type = node->chosen("type", kOrders);
  if (!type) return order;
  order.type = type->value;
  if (order.type == OrderType::Reversed) {
    order.of = node->id("of");
  } else if (node->has("of")) {
    node->problem("of", "only a reversed order is 'of' another block", "remove it");
  }
  return order;
}

ConditionQuestionnaire readQuestionnaire(const Node& node) {
  ConditionQuestionnaire questionnaire;
  if (!node.isObjectWithOnlyKeys({"instrument", "set_by_condition"})) return questionnaire;
  questionnaire.instrument = node.id("instrument");
  if (const auto sets = node.object("set_by_condition")) {
    for (const auto& member : sets->members()) {
      questionnaire.setByCondition.emplace_back(member.first, sets->id(member.first));
    }
  }
  return questionnaire;
}

std::vector<std::string> readConditions(const Node& block) {
  if (block.requiredList("conditions").empty()) return {};
  const auto conditions = block.ids("conditions");
  if (conditions.size() <= std::size_t{kMostConditions}) return conditions;
  block.problem(
      "conditions",
      "more than " + std::to_string(kMostConditions) + " conditions in one block",
      "nobody can compare so many; make several blocks");
  return {};
}

void readBlock(const Node& node, Phase& phase) {
  if (!node.isObjectWithOnlyKeys(
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
  block.conditions = readConditions(node);
  if (node.has("visualisation")) block.isVisualised = node.flag("visualisation", false);
  block.order = readOrder(node);
  block.minimumCuts = static_cast<int>(node.wholeNumber("minimum_cuts", 1, kMostCuts));
  for (const auto& asked : node.list("questionnaires")) {
    block.questionnaires.push_back(readQuestionnaire(asked));
  }
}

void readBenchmark(const Node& node, Phase& phase) {
  if (!node.isObjectWithOnlyKeys({"id", "type", "text", "minimum_cuts"})) return;
  phase.text = readLocalized(node, "text");
  phase.minimumCuts = static_cast<int>(node.wholeNumber("minimum_cuts", 1, kMostCuts));
}

void readBreak(const Node& node, Phase& phase) {
  constexpr double kLongestBreak = 86'400.0;  // [s]
  if (!node.isObjectWithOnlyKeys({"id", "type", "text", "seconds"})) return;
  phase.text = readLocalized(node, "text");
  phase.seconds = node.number("seconds", 0.0, kLongestBreak, 0.0);
}

void readPreference(const Node& node, Phase& phase) {
  if (!node.isObjectWithOnlyKeys({"id", "type", "instrument", "block", "feel_again"})) return;
  phase.instrument = node.id("instrument");
  phase.block = node.id("block");
  phase.hasOptionalTrials = node.flag("feel_again", false);
}

void readWithInstrument(const Node& node, Phase& phase) {
  if (node.isObjectWithOnlyKeys({"id", "type", "instrument"}))
    phase.instrument = node.id("instrument");
}

}  // namespace

Phase readPhase(const Node& node) {
  Phase phase;
  if (!node.isObject()) {
    node.isObjectWithOnlyKeys({});
    return phase;
  }
  const std::string id = node.id("id");
  const auto type = node.chosen("type", kPhaseTypes);
  if (!type) return phase;
  phase.id = id;
  phase.type = type->value;
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
