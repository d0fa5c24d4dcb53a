#include <array>
#include <cmath>
#include <string>

#include "questionnaires/reading/instrument_reader.h"

namespace questionnaires {
namespace {

constexpr double kLargestFactor = 1e6;
constexpr std::array kAggregates{
    Choice<Score::Aggregate>{"mean", Score::Aggregate::Mean},
    Choice<Score::Aggregate>{"sum", Score::Aggregate::Sum},
    Choice<Score::Aggregate>{"count", Score::Aggregate::Count},
};

void refuseBothKeys(const Node& node, std::string_view key, std::string_view other) {
  if (!node.has(key) || !node.has(other)) return;
  node.problem(
      key, "'" + std::string(key) + "' beside '" + std::string(other) + "'", "keep one of the two");
}

/// Reads the keys that only some scores have: weights, from the file or from pairwise choices, and
/// the threshold of a count.
void readWeights(const Node& node, Score& score) {
  score.weights = node.numbers("weights", 0.0, kLargestFactor);
  if (node.has("weights_from")) {
    score.weightsFrom = node.ids("weights_from");
    if (score.weightsFrom.empty()) {
      node.problem("weights_from", "no pair is named", "name the pairwise_choice items");
    }
  }
  refuseBothKeys(node, "weights", "weights_from");
  refuseBothKeys(node, "least_answered", "weights_from");
  refuseBothKeys(node, "missing_as", "weights_from");
}

void readCount(const Node& node, Score& score) {
  const bool isCount = score.aggregate == Score::Aggregate::Count;
  if (isCount) {
    score.countFrom = node.number("count_from", -kLargestFactor, kLargestFactor);
    for (const auto* key : {"weights", "weights_from"}) {
      if (node.has(key)) node.problem(key, "a count weighs nothing", "leave it out");
    }
  } else if (node.has("count_from")) {
    node.problem(
        "count_from", "only a count counts from somewhere", "write \"aggregate\": \"count\"");
  }
}

void readMissing(const Node& node, Score& score) {
  score.leastAnswered =
      static_cast<std::size_t>(node.wholeNumber("least_answered", 0, kMostElements, 0));
  if (!node.has("missing_as")) return;
  const double missing = node.number("missing_as", -kLargestFactor, kLargestFactor, kUnreadNumber);
  if (!std::isnan(missing)) score.missingAs = missing;
  if (node.wholeNumber("least_answered", 0, kMostElements, 0) > 0) return;
  node.problem(
      "missing_as",
      "it is never used: without 'least_answered' all answers are needed",
      "write how many must be there");
}

}  // namespace

Score readScore(const Node& node, const TextReader& texts, std::size_t index) {
  Score score;
  score.id = "unread." + std::to_string(index);
  score.title = texts.fallbackText();
  if (!node.isObjectWithOnlyKeys(
          {"id",
           "title",
           "items",
           "aggregate",
           "reverse_by_key",
           "least_answered",
           "offset",
           "factor",
           "count_from",
           "weights",
           "weights_from",
           "missing_as"})) {
    return score;
  }
  score.id = idOrGenerated(node, "id", index);
  score.title = texts.required(node, "title");
  score.items = node.ids("items");
  score.aggregate = node.choice("aggregate", kAggregates, score.aggregate);
  score.reverseByKey = node.flag("reverse_by_key", true);
  score.offset = node.number("offset", -kLargestFactor, kLargestFactor, 0.0);
  score.factor = node.number("factor", -kLargestFactor, kLargestFactor, 1.0);
  readMissing(node, score);
  readWeights(node, score);
  readCount(node, score);
  return score;
}

ConsistencyRule readConsistencyRule(const Node& node) {
  ConsistencyRule rule;
  if (!node.isObjectWithOnlyKeys({"scores", "widest_range", "suspicious_from"})) return rule;
  node.require("scores");
  rule.scores = node.ids("scores");
  rule.widestRange = node.number("widest_range", 0.0, kLargestFactor);
  rule.suspiciousFrom =
      static_cast<std::size_t>(node.wholeNumber("suspicious_from", 1, kMostElements));
  return rule;
}

}  // namespace questionnaires
