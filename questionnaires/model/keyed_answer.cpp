#include "questionnaires/model/keyed_answer.h"

#include <algorithm>

#include "questionnaires/model/range.h"

namespace questionnaires {

std::optional<double> answerAsNumber(const Item& item, const std::vector<Answer>& answers) {
  if (!rangeOf(item)) return std::nullopt;
  const auto last = std::find_if(answers.rbegin(), answers.rend(), [&](const Answer& answer) {
    return answer.itemId == item.id;
  });
  if (last == answers.rend() || !last->response || objection(item, *last->response)) {
    return std::nullopt;
  }
  const auto* whole = std::get_if<std::int64_t>(&*last->response);
  return whole != nullptr ? static_cast<double>(*whole) : std::get<double>(*last->response);
}

double keyedNumber(const Item& item, double number) {
  const auto range = rangeOf(item);
  return range && item.key == -1 ? range->low + range->high - number : number;
}

}  // namespace questionnaires
