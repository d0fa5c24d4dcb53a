#include "questionnaires/score_problems.h"

#include <cmath>
#include <optional>
#include <set>

#include "questionnaires/document.h"
#include "questionnaires/range.h"
#include "questionnaires/text_problems.h"

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
    problems.warn(
        path + ".items",
        "these items are answered on different ranges",
        "the widest weighs most: is that meant?");
  }
}

void inspectHowManyAnswers(const Score& score, const std::string& path, Problems& problems) {
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
  if (score.aggregate == Score::Aggregate::Sum && mayMiss) {
    problems.add(
        path + ".least_answered",
        "a sum with answers missing would count them as zero",
        "leave it out, or use the mean and a factor");
  }
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
  if (!isSoundId(score.id)) {
    problems.add(path + ".id", "'" + shown(score.id) + "' cannot be an id", "give it a name");
  }
  if (instrument.item(score.id) != nullptr) {
    problems.add(
        path + ".id",
        "'" + shown(score.id) + "' is the id of an item too",
        "a column needs a name of its own");
  }
  const TextProblems texts(instrument.languages, problems);
  texts.inspectForResearchers(path + ".title", score.title);
  inspectScoredItems(instrument, score, path, problems);
  inspectHowManyAnswers(score, path, problems);
  inspectArithmetic(score, path, problems);
}

}  // namespace questionnaires
