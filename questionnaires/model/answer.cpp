#include "questionnaires/model/answer.h"

#include <algorithm>

#include "base/joined.h"
#include "base/search.h"
#include "questionnaires/model/instrument.h"

namespace questionnaires {

namespace {

/// The label of an end of the scale if @p value is at that end; otherwise empty.
std::string endLabel(
    double value,
    double low,
    double high,
    const LocalizedText& lowText,
    const LocalizedText& highText,
    std::string_view language) {
  if (value == low) return lowText.in(language);
  return value == high ? highText.in(language) : std::string();
}

std::string pointLabel(const Item& item, std::int64_t point, std::string_view language) {
  const Scale& scale = item.scale;
  const std::int64_t index = point - scale.lowest;
  const bool hasLabel = index >= 0 && static_cast<std::size_t>(index) < scale.pointLabels.size();
  if (hasLabel) return scale.pointLabels[static_cast<std::size_t>(index)].in(language);
  const bool isPair = item.type == ItemType::SemanticDifferential;
  return endLabel(
      static_cast<double>(point),
      scale.lowest,
      scale.highest(),
      isPair ? item.leftText : scale.lowLabel,
      isPair ? item.rightText : scale.highLabel,
      language);
}

std::string optionLabel(const Item& item, const std::string& id, std::string_view language) {
  const auto* option = base::withId(item.options, id);
  return option == nullptr ? std::string() : option->text.in(language);
}

bool isEmpty(const Response& response) {
  if (const auto* text = std::get_if<std::string>(&response)) {
    return text->find_first_not_of(" \t\r\n") == std::string::npos;
  }
  const auto* chosen = std::get_if<std::vector<std::string>>(&response);
  return chosen != nullptr && chosen->empty();
}

std::string numberLabel(const Item& item, double number, std::string_view language) {
  if (item.type != ItemType::Slider) return {};
  return endLabel(number, item.least, item.most, item.leftText, item.rightText, language);
}

std::string optionLabels(
    const Item& item, const std::vector<std::string>& ids, std::string_view language) {
  return base::joined(ids, "; ", [&](const auto& id) { return optionLabel(item, id, language); });
}

}  // namespace

std::string labelOf(const Item& item, const Response& response, std::string_view language) {
  const bool isPoint = answerKindOf(item.type) == AnswerKind::Point;
  if (const auto* whole = std::get_if<std::int64_t>(&response)) {
    return isPoint ? pointLabel(item, *whole, language)
                   : numberLabel(item, static_cast<double>(*whole), language);
  }
  if (const auto* number = std::get_if<double>(&response)) {
    return numberLabel(item, *number, language);
  }
  if (const auto* chosen = std::get_if<std::string>(&response)) {
    return optionLabel(item, *chosen, language);
  }
  return optionLabels(item, std::get<std::vector<std::string>>(response), language);
}

std::int64_t keyedPoint(const Item& item, std::int64_t point) noexcept {
  return item.key == -1 ? std::int64_t{item.scale.lowest} + item.scale.highest() - point : point;
}

const Response* lastResponse(std::string_view itemId, const std::vector<Answer>& answers) {
  const auto last = std::find_if(
      answers.rbegin(), answers.rend(), [&](const Answer& one) { return one.itemId == itemId; });
  return last == answers.rend() || !last->response ? nullptr : &*last->response;
}

bool isAsked(const Item& item, const std::vector<Item>& items, const std::vector<Answer>& answers) {
  if (!item.showIf.isSet()) return true;
  const auto* asked = base::withId(items, item.showIf.item);
  // The recursion ends, because an item's condition names an earlier item (problemsOf()).
  if (asked == nullptr || asked == &item || !isAsked(*asked, items, answers)) return false;
  const auto* last = lastResponse(asked->id, answers);
  if (last == nullptr) return false;
  const auto& wanted = item.showIf.wantedOptions;
  const auto isWantedOption = [&](const std::string& id) { return base::contains(wanted, id); };
  if (const auto* chosen = std::get_if<std::string>(last)) return isWantedOption(*chosen);
  const auto* several = std::get_if<std::vector<std::string>>(last);
  return several != nullptr && std::ranges::any_of(*several, isWantedOption);
}

std::vector<std::string> unansweredItems(
    const std::vector<Item>& items, const std::vector<Answer>& answers) {
  const auto isAnswered = [&](const Item& item) {
    return std::ranges::any_of(answers, [&](const Answer& answer) {
      return answer.itemId == item.id && answer.response && !isEmpty(*answer.response);
    });
  };
  std::vector<std::string> ids;
  for (const auto& item : items) {
    if (!item.isRequired || isAnswered(item)) continue;
    if (isAsked(item, items, answers)) ids.push_back(item.id);
  }
  return ids;
}

std::optional<double> answerAsNumber(const Item& item, const std::vector<Answer>& answers) {
  if (!rangeOf(item)) return std::nullopt;
  const auto* last = lastResponse(item.id, answers);
  if (last == nullptr || validationError(item, *last)) return std::nullopt;
  const auto* whole = std::get_if<std::int64_t>(last);
  return whole != nullptr ? static_cast<double>(*whole) : std::get<double>(*last);
}

double keyedNumber(const Item& item, double number) {
  const auto range = rangeOf(item);
  return range && item.key == -1 ? range->low + range->high - number : number;
}

}  // namespace questionnaires
