#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "base/search.h"
#include "questionnaires/json/document.h"
#include "questionnaires/model/instrument.h"
#include "questionnaires/reading/instrument_problems.h"

namespace questionnaires {
namespace {

void inspectScoredItem(
    const Instrument& instrument,
    const std::string& id,
    const std::string& path,
    Problems& problems) {
  const Item* item = instrument.item(id);
  const std::string named = "'" + shown(id) + "'";
  if (item == nullptr) {
    return problems.add(path, "there is no item " + named, "name the id of an item");
  }
  if (!rangeOf(*item)) {
    problems.add(
        path,
        "answers to " + named + " are no numbers",
        "score likert, semantic_differential, slider and number items");
  }
  if (item->isIdentifying) {
    problems.add(path, named + " names a person", "such answers are never scored");
  }
}

void inspectScoredItems(
    const Instrument& instrument, const Score& score, const std::string& path, Problems& problems) {
  std::set<std::string> ids;
  std::optional<Range> first;
  bool areAlike = true;
  for (std::size_t i = 0; i < score.items.size(); ++i) {
    const std::string& id = score.items[i];
    const std::string place = path + ".items[" + std::to_string(i) + "]";
    if (!ids.insert(id).second) {
      problems.add(place, "'" + shown(id) + "' stands in this list twice", "keep one");
    }
    inspectScoredItem(instrument, id, place, problems);
    const Item* item = instrument.item(id);
    const auto range = item == nullptr ? std::nullopt : rangeOf(*item);
    if (!first) first = range;
    areAlike = areAlike && (!range || *range == *first);
  }
  if (!areAlike) {
    problems.warn(path + ".items", warning("different_ranges"), warning("different_ranges.fix"));
  }
}

void inspectAnswerCount(const Score& score, const std::string& path, Problems& problems) {
  if (score.items.empty()) {
    return problems.add(path + ".items", "this score counts no items", "name at least one");
  }
  if (score.leastAnswered > score.items.size()) {
    problems.add(
        path + ".least_answered",
        "more answers are needed than there are items",
        "write at most " + std::to_string(score.items.size()));
  }
  const bool mayMiss = score.leastAnswered > 0 && score.leastAnswered < score.items.size();
  if (score.aggregate != Score::Aggregate::Mean && mayMiss && !score.missingAs) {
    problems.add(
        path + ".least_answered",
        std::string(score.aggregate == Score::Aggregate::Sum ? "a sum" : "a count") +
            " with answers missing would count them as zero",
        "leave it out, or say what they count as with missing_as");
  }
}

void inspectMissingAs(
    const Instrument& instrument, const Score& score, const std::string& path, Problems& problems) {
  if (!score.missingAs) return;
  for (const auto& id : score.items) {
    const Item* item = instrument.item(id);
    const auto range = item == nullptr ? std::nullopt : rangeOf(*item);
    if (!range || (*score.missingAs >= range->low && *score.missingAs <= range->high)) continue;
    return problems.add(
        path + ".missing_as",
        "nobody can answer " + shown(*score.missingAs) + " to '" + shown(id) + "'",
        "write a number from " + shown(range->low) + " to " + shown(range->high));
  }
}

void inspectWeights(const Score& score, const std::string& path, Problems& problems) {
  if (score.weights.empty()) return;
  if (score.weights.size() != score.items.size()) {
    return problems.add(
        path + ".weights",
        std::to_string(score.weights.size()) + " weights for " +
            std::to_string(score.items.size()) + " items",
        "write one for each item, in the same order");
  }
  const bool isSound = std::ranges::all_of(
      score.weights, [](double weight) { return std::isfinite(weight) && weight >= 0.0; });
  const bool hasPositiveWeight =
      std::ranges::any_of(score.weights, [](double weight) { return weight > 0.0; });
  if (isSound && hasPositiveWeight) return;
  problems.add(path + ".weights", "these weights count nothing", "write numbers above 0");
}

/// The ids of the two items that are the options of the pairwise choice @p id; std::nullopt, with a
/// problem, if there is no such choice.
std::optional<std::set<std::string>> pairOf(
    const Instrument& instrument,
    const Score& score,
    const std::string& id,
    const std::string& place,
    Problems& problems) {
  const Item* item = instrument.item(id);
  const std::string named = "'" + shown(id) + "'";
  if (item == nullptr || item->type != ItemType::PairwiseChoice) {
    problems.add(place, named + " is no pairwise_choice item", "name one");
    return std::nullopt;
  }
  std::set<std::string> pair;
  for (const auto& option : item->options) {
    if (!base::contains(score.items, option.id)) {
      problems.add(
          place,
          named + " offers '" + shown(option.id) + "', which this score does not count",
          "give its options the ids of two items of the score");
      return std::nullopt;
    }
    pair.insert(option.id);
  }
  return pair;
}

void inspectPairs(
    const Instrument& instrument, const Score& score, const std::string& path, Problems& problems) {
  std::set<std::set<std::string>> pairs;
  for (std::size_t i = 0; i < score.weightsFrom.size(); ++i) {
    const std::string place = path + ".weights_from[" + std::to_string(i) + "]";
    const auto pair = pairOf(instrument, score, score.weightsFrom[i], place, problems);
    if (pair && !pairs.insert(*pair).second) {
      problems.add(place, "these two are compared in a pair before", "keep one of the pairs");
    }
  }
  const std::size_t all = score.items.size() * (score.items.size() - 1) / 2;
  if (score.weightsFrom.empty() || pairs.size() >= all) return;
  problems.warn(
      path + ".weights_from",
      warning("some_pairs_asked", pairs.size(), all),
      warning("some_pairs_asked.fix"));
}

void inspectArithmetic(const Score& score, const std::string& path, Problems& problems) {
  if (!std::isfinite(score.factor) || score.factor == 0.0) {
    problems.add(path + ".factor", "this factor makes every score the same", "leave it out");
  }
  if (!std::isfinite(score.offset)) {
    problems.add(path + ".offset", "the offset is no finite number", "leave it out");
  }
}

}  // namespace

void inspectScore(
    const Instrument& instrument, const Score& score, const std::string& path, Problems& problems) {
  if (!isValidId(score.id)) {
    problems.add(path + ".id", "'" + shown(score.id) + "' cannot be an id", "give it a name");
  }
  if (instrument.item(score.id) != nullptr) {
    problems.add(
        path + ".id",
        "'" + shown(score.id) + "' is the id of an item too",
        "a column needs a name of its own");
  }
  const TextCheck texts(instrument.languages, problems);
  texts.inspectResearcherText(path + ".title", score.title);
  inspectScoredItems(instrument, score, path, problems);
  inspectAnswerCount(score, path, problems);
  inspectMissingAs(instrument, score, path, problems);
  inspectWeights(score, path, problems);
  if (!score.items.empty()) inspectPairs(instrument, score, path, problems);
  inspectArithmetic(score, path, problems);
}

void inspectConsistency(const Instrument& instrument, Problems& problems) {
  if (!instrument.consistency) return;
  const auto& rule = *instrument.consistency;
  const std::string path = "$.consistency";
  for (std::size_t i = 0; i < rule.scores.size(); ++i) {
    if (instrument.score(rule.scores[i]) != nullptr) continue;
    problems.add(
        path + ".scores[" + std::to_string(i) + "]",
        "there is no score '" + shown(rule.scores[i]) + "'",
        "name the id of a score");
  }
  if (rule.scores.empty()) {
    problems.add(path + ".scores", "no score is looked at", "name at least one");
  } else if (rule.suspiciousFrom > rule.scores.size()) {
    problems.add(
        path + ".suspicious_from",
        "more contradictions are needed than there are scores",
        "write at most " + std::to_string(rule.scores.size()));
  }
}

}  // namespace questionnaires
