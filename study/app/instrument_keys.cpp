#include "study/app/instrument_keys.h"

#include <cmath>

#include <fmt/format.h>

#include "questionnaires/json/document.h"
#include "questionnaires/model/instrument.h"

namespace study::app {
namespace {

using questionnaires::Instrument;
using questionnaires::Item;
using questionnaires::Score;
using questionnaires::shown;

std::string keyLineOf(const Item& item) {
  const auto range = questionnaires::rangeOf(item);
  if (!range) return {};
  const std::string counts =
      item.key == -1 ? "reversed: x counts " + shown(range->low + range->high) + " - x" : "";
  const std::string threshold =
      item.acceptableFrom ? "acceptable from " + shown(*item.acceptableFrom) : "";
  std::string line =
      fmt::format("{:<28} {} ... {}", item.id, shown(range->low), shown(range->high));
  for (const auto& words : {counts, threshold}) {
    if (!words.empty()) line += "  " + words;
  }
  return line + "\n";
}

std::string weightedNames(const Score& score) {
  std::string names;
  for (std::size_t i = 0; i < score.items.size(); ++i) {
    names += names.empty() ? "" : ", ";
    const bool hasWeight = i < score.weights.size() && score.weights[i] != 1.0;
    names += (hasWeight ? shown(score.weights[i]) + " * " : "") + score.items[i];
  }
  return names;
}

std::string aggregateOf(const Score& score) {
  const bool isWeighted = !score.weights.empty() || !score.weightsFrom.empty();
  const std::string names = "(" + weightedNames(score) + ")";
  switch (score.aggregate) {
    case Score::Aggregate::Sum:
      return (isWeighted ? "weighted sum" : "sum") + names;
    case Score::Aggregate::Count:
      return "how many are at least " + shown(score.countFrom) + " of " + names;
    case Score::Aggregate::Mean:
      break;
  }
  return (isWeighted ? "weighted mean" : "mean") + names;
}

std::string missingRuleOf(const Score& score) {
  const bool needsAll = score.leastAnswered == 0 || score.leastAnswered >= score.items.size();
  if (needsAll) return "every answer is needed";
  std::string words = score.leastAnswered == 1
                          ? "at least one answer is needed"
                          : fmt::format("at least {} answers are needed", score.leastAnswered);
  if (score.missingAs) words += ", a missing one counts as " + shown(*score.missingAs);
  return words;
}

std::string formulaOf(const Score& score) {
  std::string formula = aggregateOf(score);
  if (score.offset != 0.0) {
    formula = fmt::format(
        "({} {} {})", formula, score.offset < 0.0 ? "-" : "+", shown(std::abs(score.offset)));
  }
  if (score.factor != 1.0) formula += " * " + shown(score.factor);
  return formula;
}

}  // namespace

std::string keysInWords(const Instrument& instrument) {
  std::string text;
  for (const auto& item : instrument.items) text += keyLineOf(item);
  for (const auto& score : instrument.scores) {
    text += fmt::format("\n{}: {}\n  = {}\n", score.id, score.title.in("en"), formulaOf(score));
    text += "  " + missingRuleOf(score);
    if (!score.reverseByKey) text += "; nothing is reversed";
    if (!score.weightsFrom.empty()) {
      text += fmt::format(
          "; the weights are how often each was chosen in {} pairs", score.weightsFrom.size());
    }
    text += "\n";
  }
  if (instrument.occasions == questionnaires::Occasions::BeforeAndAfter) {
    text += "\nAsked before and after: the result of each score is after - before.\n";
  }
  if (const auto& rule = instrument.consistency) {
    text += fmt::format(
        "\nSuspicious where the answers within {} of {} scores lie more than {} apart.\n",
        rule->suspiciousFrom,
        rule->scores.size(),
        shown(rule->widestRange));
  }
  return text.empty() ? "Nothing is scored here.\n" : text;
}

}  // namespace study::app
