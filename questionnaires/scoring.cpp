#include "questionnaires/scoring.h"

#include <algorithm>
#include <numeric>

#include "questionnaires/range.h"

namespace questionnaires {
namespace {

/// The answer to @p item as a number; nothing where there is none that can be one.
std::optional<double> numberOf(const Item& item, const std::vector<Answer>& answers) {
  const auto last = std::find_if(answers.rbegin(), answers.rend(), [&](const Answer& answer) {
    return answer.itemId == item.id;
  });
  if (last == answers.rend() || !last->response || objection(item, *last->response)) {
    return std::nullopt;
  }
  const auto* whole = std::get_if<std::int64_t>(&*last->response);
  return whole != nullptr ? static_cast<double>(*whole) : std::get<double>(*last->response);
}

std::vector<double> keyedNumbers(
    const Instrument& instrument, const Score& score, const std::vector<Answer>& answers) {
  std::vector<double> numbers;
  for (const auto& id : score.items) {
    const Item* item = instrument.item(id);
    const auto range = item == nullptr ? std::nullopt : rangeOf(*item);
    const auto number = range ? numberOf(*item, answers) : std::nullopt;
    if (!number) continue;
    const bool isReversed = score.reverseByKey && item->key == -1;
    numbers.push_back(isReversed ? range->low + range->high - *number : *number);
  }
  return numbers;
}

}  // namespace

std::optional<double> scored(
    const Instrument& instrument, const Score& score, const std::vector<Answer>& answers) {
  const auto numbers = keyedNumbers(instrument, score, answers);
  const bool isMean = score.aggregate == Score::Aggregate::Mean;
  const bool mayMiss = isMean && score.leastAnswered > 0;
  const std::size_t needed = mayMiss ? score.leastAnswered : score.items.size();
  if (numbers.empty() || numbers.size() < needed) return std::nullopt;

  const double sum = std::accumulate(numbers.begin(), numbers.end(), 0.0);
  const double aggregate = isMean ? sum / static_cast<double>(numbers.size()) : sum;
  return (aggregate + score.offset) * score.factor;
}

}  // namespace questionnaires
