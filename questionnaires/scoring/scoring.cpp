#include "questionnaires/scoring/scoring.h"

#include <algorithm>

#include "questionnaires/json/document.h"
#include "questionnaires/model/answer.h"

namespace questionnaires {
namespace {

/// The answer to an item, reversed if the item is reverse-keyed, and its weight.
struct WeightedAnswer {
  double x = 0.0;
  double weight = 1.0;
};

/// The id of the option that was chosen in the pairwise choice @p id; std::nullopt if none was.
std::optional<std::string> chosenOption(
    const Instrument& instrument, const std::string& id, const std::vector<Answer>& answers) {
  const Item* pair = instrument.item(id);
  if (pair == nullptr || pair->type != ItemType::PairwiseChoice) return std::nullopt;
  const auto* last = lastResponse(id, answers);
  if (last == nullptr || validationError(*pair, *last)) return std::nullopt;
  return std::get<std::string>(*last);
}

/// The number of items that must be answered for the score.
std::size_t requiredAnswerCount(const Score& score) {
  const bool mayMiss = score.aggregate == Score::Aggregate::Mean || score.missingAs.has_value();
  const bool hasMinimum = score.leastAnswered > 0 && score.weightsFrom.empty();
  return mayMiss && hasMinimum ? score.leastAnswered : score.items.size();
}

/// The answers to the items of the score, and the values that replace missing answers.
/// @param weights  weights of the items; empty if every weight is 1
std::vector<WeightedAnswer> countedAnswers(
    const Instrument& instrument,
    const Score& score,
    const std::vector<double>& weights,
    const std::vector<Answer>& answers,
    ScoreResult& result) {
  std::vector<WeightedAnswer> counted;
  for (std::size_t i = 0; i < score.items.size(); ++i) {
    const Item* item = instrument.item(score.items[i]);
    if (item == nullptr) continue;
    auto number = answerAsNumber(*item, answers);
    if (number) {
      ++result.answered;
    } else {
      number = score.missingAs;
    }
    if (!number) continue;
    const double x = score.reverseByKey ? keyedNumber(*item, *number) : *number;
    counted.push_back({x, i < weights.size() ? weights[i] : 1.0});
  }
  return counted;
}

std::optional<double> aggregateOf(const Score& score, const std::vector<WeightedAnswer>& counted) {
  double sum = 0.0;
  double weights = 0.0;
  double count = 0.0;
  for (const auto& [x, weight] : counted) {
    sum += weight * x;
    weights += weight;
    if (x >= score.countFrom) count += 1.0;
  }
  switch (score.aggregate) {
    case Score::Aggregate::Sum:
      return sum;
    case Score::Aggregate::Count:
      return count;
    case Score::Aggregate::Mean:
      break;
  }
  return weights > 0.0 ? std::optional(sum / weights) : std::nullopt;
}

std::string reasonFor(const ScoreResult& result, const Score& score) {
  return std::to_string(result.answered) + " of " + std::to_string(score.items.size()) +
         " items were answered; this score needs " + std::to_string(requiredAnswerCount(score));
}

}  // namespace

std::optional<std::vector<double>> pairWeights(
    const Instrument& instrument, const Score& score, const std::vector<Answer>& answers) {
  if (score.weightsFrom.empty()) return std::nullopt;
  std::vector<double> weights(score.items.size(), 0.0);
  for (const auto& id : score.weightsFrom) {
    const auto chosen = chosenOption(instrument, id, answers);
    if (!chosen) return std::nullopt;
    const auto item = std::ranges::find(score.items, *chosen);
    if (item == score.items.end()) return std::nullopt;
    weights[static_cast<std::size_t>(item - score.items.begin())] += 1.0;
  }
  return weights;
}

ScoreResult computeScore(
    const Instrument& instrument, const Score& score, const std::vector<Answer>& answers) {
  ScoreResult result;
  std::vector<double> weights = score.weights;
  if (!score.weightsFrom.empty()) {
    const auto chosen = pairWeights(instrument, score, answers);
    if (!chosen) {
      result.reason = "a pair was left open, and the weights come from all of them";
      return result;
    }
    weights = *chosen;
  }
  const auto counted = countedAnswers(instrument, score, weights, answers, result);
  if (counted.empty() || result.answered < requiredAnswerCount(score)) {
    result.reason = reasonFor(result, score);
    return result;
  }
  const auto aggregate = aggregateOf(score, counted);
  if (!aggregate) {
    result.reason = "every item that was answered has the weight 0";
    return result;
  }
  result.value = (*aggregate + score.offset) * score.factor;
  return result;
}

Range rangeOf(const Instrument& instrument, const Score& score) {
  std::optional<Range> widest;
  Range sum;
  for (std::size_t i = 0; i < score.items.size(); ++i) {
    const Item* item = instrument.item(score.items[i]);
    const auto range = item == nullptr ? std::nullopt : rangeOf(*item);
    if (!range) continue;
    if (!widest) widest = range;
    widest = Range{std::min(widest->low, range->low), std::max(widest->high, range->high)};
    const double weight = i < score.weights.size() ? score.weights[i] : 1.0;
    sum.low += weight * range->low;
    sum.high += weight * range->high;
  }
  Range range = widest.value_or(Range{});
  if (score.aggregate == Score::Aggregate::Sum) range = sum;
  if (score.aggregate == Score::Aggregate::Sum && !score.weightsFrom.empty() && widest) {
    const auto n = static_cast<double>(score.items.size());
    const double pairs = n * (n - 1.0) / 2.0;  // the weights sum to the number of pairs
    range = {pairs * widest->low, pairs * widest->high};
  }
  if (score.aggregate == Score::Aggregate::Count) {
    range = {0.0, static_cast<double>(score.items.size())};
  }
  const double first = (range.low + score.offset) * score.factor;
  const double last = (range.high + score.offset) * score.factor;
  return {std::min(first, last), std::max(first, last)};
}

std::optional<double> scoreValue(
    const Instrument& instrument, const Score& score, const std::vector<Answer>& answers) {
  return computeScore(instrument, score, answers).value;
}

ScoreChange scoreChange(
    const Instrument& instrument,
    const Score& score,
    const std::vector<Answer>& before,
    const std::vector<Answer>& after) {
  const auto first = computeScore(instrument, score, before);
  const auto last = computeScore(instrument, score, after);
  ScoreChange result{.before = first.value, .after = last.value, .change = {}, .reason = {}};
  if (first.value && last.value) {
    result.change = *last.value - *first.value;
  } else {
    result.reason = !first.value ? "before: " + first.reason : "after: " + last.reason;
  }
  return result;
}

namespace {

Acceptability acceptabilityOf(
    const Item& item, double threshold, const std::vector<std::vector<Answer>>& participants) {
  Acceptability result{.itemId = item.id, .acceptableFrom = threshold, .share = {}, .reason = {}};
  for (const auto& answers : participants) {
    const auto number = answerAsNumber(item, answers);
    if (!number) continue;
    ++result.answered;
    if (keyedNumber(item, *number) >= threshold) ++result.acceptable;
  }
  if (result.answered == 0) {
    result.reason = "nobody answered this item";
  } else {
    result.share = static_cast<double>(result.acceptable) / static_cast<double>(result.answered);
  }
  return result;
}

}  // namespace

std::vector<Acceptability> acceptabilityOf(
    const Instrument& instrument, const std::vector<std::vector<Answer>>& participants) {
  std::vector<Acceptability> result;
  for (const auto& item : instrument.items) {
    if (!item.acceptableFrom) continue;
    result.push_back(acceptabilityOf(item, *item.acceptableFrom, participants));
  }
  return result;
}

namespace {

/// The range (largest minus smallest) of keyed answers to the items of @p score; 0 for fewer than
/// two.
double rangeOfAnswers(
    const Instrument& instrument, const Score& score, const std::vector<Answer>& answers) {
  std::vector<double> given;
  for (const auto& id : score.items) {
    const Item* item = instrument.item(id);
    const auto number = item == nullptr ? std::nullopt : answerAsNumber(*item, answers);
    if (number) given.push_back(keyedNumber(*item, *number));
  }
  if (given.empty()) return 0.0;
  const auto [least, most] = std::minmax_element(given.begin(), given.end());
  return *most - *least;
}

}  // namespace

std::optional<Consistency> consistencyOf(
    const Instrument& instrument, const std::vector<Answer>& answers) {
  if (!instrument.consistency) return std::nullopt;
  const auto& rule = *instrument.consistency;
  Consistency result;
  for (const auto& id : rule.scores) {
    const Score* score = instrument.score(id);
    if (score == nullptr) continue;
    if (rangeOfAnswers(instrument, *score, answers) > rule.widestRange) {
      result.contradictoryScores.push_back(id);
    }
  }
  result.isSuspicious = result.contradictoryScores.size() >= rule.suspiciousFrom;
  if (!result.isSuspicious) return result;
  result.warning = "in " + std::to_string(result.contradictoryScores.size()) + " of " +
                   std::to_string(rule.scores.size()) + " scales the answers lie more than " +
                   shown(rule.widestRange) +
                   " apart: they may not have been meant; look at them before you count them";
  return result;
}

}  // namespace questionnaires
