#include <array>

#include "protocols/reading/protocol_parts.h"

namespace protocols {
namespace {

using questionnaires::Choice;
using questionnaires::Node;

constexpr std::array kTests{
    Choice<TestType>{"welch", TestType::Welch},
    Choice<TestType>{"paired_t", TestType::PairedT},
    Choice<TestType>{"sign_flip", TestType::SignFlip},
    Choice<TestType>{"signed_rank", TestType::SignedRank},
};
constexpr std::array kCorrections{
    Choice<CorrectionType>{"bonferroni", CorrectionType::Bonferroni},
    Choice<CorrectionType>{"holm", CorrectionType::Holm},
    Choice<CorrectionType>{"hochberg", CorrectionType::Hochberg},
    Choice<CorrectionType>{"hommel", CorrectionType::Hommel},
    Choice<CorrectionType>{"bh", CorrectionType::BenjaminiHochberg},
    Choice<CorrectionType>{"by", CorrectionType::BenjaminiYekutieli},
    Choice<CorrectionType>{"holm_sidak", CorrectionType::HolmSidak},
    Choice<CorrectionType>{"none", CorrectionType::None},
};
constexpr double kWidestScale = 1000.0;  // [points]
constexpr double kLargestRealism = 10.0;
constexpr double kMostStandardDeviation = 10.0;  // of simulated answers [points]

Comparison readComparison(const Node& node) {
  if (!node.isObjectWithOnlyKeys({"first", "second"})) return {};
  return {node.id("first"), node.id("second")};
}

double readAlpha(const Node& family) {
  constexpr double kUsual = 0.05;
  if (!family.has("alpha")) {
    family.problem("", "'alpha' is missing", "add it; 0.05 is usual");
    return kUsual;
  }
  const double alpha = family.number("alpha", 0.0, 1.0, kUsual);
  if (alpha == 0.0 || alpha == 1.0) {
    family.problem("alpha", "alpha must lie between 0 and 1, both excluded", "0.05 is usual");
  }
  return alpha;
}

Family readFamily(const Node& node) {
  Family family;
  if (!node.isObjectWithOnlyKeys(
          {"id",
           "title",
           "instrument",
           "items",
           "score",
           "blocks",
           "comparisons",
           "test",
           "correction",
           "alpha",
           "equivalence_bound"})) {
    return family;
  }
  family.id = node.id("id");
  family.title = node.text("title");
  family.instrument = node.id("instrument");
  family.items = node.ids("items");
  if (node.has("score")) family.score = node.id("score");
  if (node.has("score") && node.has("items")) {
    node.problem("score", "a family compares items or a score", "leave one of the two out");
  }
  family.blocks = node.ids("blocks");
  for (const auto& pair : node.requiredList("comparisons")) {
    family.comparisons.push_back(readComparison(pair));
  }
  family.test = node.choice("test", kTests);
  family.correction = node.choice("correction", kCorrections);
  family.alpha = readAlpha(node);
  if (node.has("equivalence_bound")) {
    family.equivalenceBound = node.number("equivalence_bound", 0.0, kWidestScale, 0.5);
    if (family.equivalenceBound == 0.0) {
      node.problem("equivalence_bound", "no difference is smaller than 0", "0.5 is usual");
    }
  }
  return family;
}

double readStandardDeviation(const Node& node, std::string_view key, double fallback) {
  return node.number(key, 0.0, kMostStandardDeviation, fallback);
}

}  // namespace

AnalysisPlan readAnalysis(const Node& node) {
  AnalysisPlan plan;
  if (!node.isObjectWithOnlyKeys({"families"})) return plan;
  for (const auto& family : node.requiredList("families")) {
    plan.families.push_back(readFamily(family));
  }
  return plan;
}

SimulatedAnswerModel readSimulation(const Node& node) {
  SimulatedAnswerModel truth;
  if (!node.isObjectWithOnlyKeys(
          {"realism", "person_deviation", "person_by_condition_deviation", "answer_deviation"})) {
    return truth;
  }
  if (const auto realism = node.object("realism")) {
    for (const auto& member : realism->members()) {
      truth.realismByCondition.emplace_back(
          member.first, realism->number(member.first, -kLargestRealism, kLargestRealism, 0.0));
    }
  }
  truth.participantStandardDeviation =
      readStandardDeviation(node, "person_deviation", truth.participantStandardDeviation);
  truth.interactionStandardDeviation = readStandardDeviation(
      node, "person_by_condition_deviation", truth.interactionStandardDeviation);
  truth.residualStandardDeviation =
      readStandardDeviation(node, "answer_deviation", truth.residualStandardDeviation);
  return truth;
}

}  // namespace protocols
