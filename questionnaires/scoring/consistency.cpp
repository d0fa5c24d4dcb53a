#include "questionnaires/scoring/consistency.h"

#include <algorithm>

#include "questionnaires/json/document.h"
#include "questionnaires/model/answer.h"

namespace questionnaires {
namespace {

/// Largest minus smallest keyed answer to the items of @p score; 0 with fewer than two.
double rangeWithin(
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
    if (rangeWithin(instrument, *score, answers) > rule.widestRange) {
      result.contradictory.push_back(id);
    }
  }
  result.isSuspicious = result.contradictory.size() >= rule.suspiciousFrom;
  if (!result.isSuspicious) return result;
  result.warning = "in " + std::to_string(result.contradictory.size()) + " of " +
                   std::to_string(rule.scores.size()) + " scales the answers lie more than " +
                   inWords(rule.widestRange) +
                   " apart: they may not have been meant; look at them before you count them";
  return result;
}

}  // namespace questionnaires
