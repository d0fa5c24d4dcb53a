#include "questionnaires/scoring/acceptability.h"

#include "questionnaires/model/answer.h"

namespace questionnaires {
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

}  // namespace questionnaires
