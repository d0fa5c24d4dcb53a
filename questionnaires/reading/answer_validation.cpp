#include <cmath>
#include <set>

#include "base/search.h"
#include "questionnaires/json/document.h"
#include "questionnaires/model/answer.h"

namespace questionnaires {
namespace {

using MaybeError = std::optional<std::string>;

MaybeError validatePoint(const Item& item, const Response& response) {
  const auto* point = std::get_if<std::int64_t>(&response);
  if (point == nullptr) return "the answer is no point of the scale";
  if (*point >= item.scale.lowest && *point <= item.scale.highest()) return std::nullopt;
  return std::to_string(*point) + " is no point of the scale from " +
         std::to_string(item.scale.lowest) + " to " + std::to_string(item.scale.highest());
}

bool isOnStep(const Item& item, double number) {
  if (!(item.step > 0.0)) return true;
  // relative to a step, because decimal steps have no exact binary representation
  constexpr double kTolerance = 1e-6;
  const double steps = (number - item.least) / item.step;
  return std::abs(steps - std::round(steps)) <= kTolerance;
}

MaybeError validateNumber(const Item& item, const Response& response) {
  const auto* whole = std::get_if<std::int64_t>(&response);
  const auto* real = std::get_if<double>(&response);
  if (whole == nullptr && real == nullptr) return "the answer is no number";
  const double number = whole != nullptr ? static_cast<double>(*whole) : *real;
  if (!std::isfinite(number)) return "the answer is no finite number";
  if (number < item.least || number > item.most) {
    return shown(number) + " is not between " + shown(item.least) + " and " + shown(item.most);
  }
  if (isOnStep(item, number)) return std::nullopt;
  return shown(number) + " is between the steps of " + shown(item.step) + " from " +
         shown(item.least);
}

MaybeError validateOption(
    const Item& item, const std::string& chosen, const std::vector<std::string>& alternatives) {
  if (item.optionSource == OptionSource::Alternatives) {
    const bool isThere = base::contains(alternatives, chosen);
    return isThere ? MaybeError{} : "there is no alternative '" + shown(chosen) + "' to choose";
  }
  const bool isThere = base::withId(item.options, chosen) != nullptr;
  return isThere ? MaybeError{} : "there is no option '" + shown(chosen) + "' to choose";
}

MaybeError validateChoice(
    const Item& item, const Response& response, const std::vector<std::string>& alternatives) {
  const auto* chosen = std::get_if<std::string>(&response);
  if (chosen == nullptr) return "the answer is not one of the options";
  return validateOption(item, *chosen, alternatives);
}

MaybeError validateChoices(
    const Item& item, const Response& response, const std::vector<std::string>& alternatives) {
  const auto* chosen = std::get_if<std::vector<std::string>>(&response);
  if (chosen == nullptr) return "the answer is no list of options";
  std::set<std::string> seen;
  for (const auto& id : *chosen) {
    if (auto reason = validateOption(item, id, alternatives)) return reason;
    if (!seen.insert(id).second) return "the option '" + shown(id) + "' is chosen twice";
  }
  return std::nullopt;
}

std::size_t longestAnswer(const Item& item) {
  const auto usual = item.type == ItemType::ShortText ? kLongestShortText : kLongestLongText;
  return static_cast<std::size_t>(item.longestAnswer > 0 ? item.longestAnswer : usual);
}

MaybeError validateText(const Item& item, const Response& response) {
  const auto* text = std::get_if<std::string>(&response);
  if (text == nullptr) return "the answer is no text";
  if (text->find('\0') != std::string::npos) return "the text holds the character NUL";
  const auto characters = utf8CharacterCount(*text);
  if (!characters) return "the text is no sound UTF-8";
  if (*characters > longestAnswer(item)) {
    return "the text has " + std::to_string(*characters) + " characters; at most " +
           std::to_string(longestAnswer(item)) + " can be kept";
  }
  const bool isOneLine = text->find_first_of("\r\n") == std::string::npos;
  if (item.type == ItemType::ShortText && !isOneLine) return "the text has more than one line";
  return std::nullopt;
}

}  // namespace

std::optional<std::string> validationError(
    const Item& item, const Response& response, const std::vector<std::string>& alternatives) {
  switch (answerKindOf(item.type)) {
    case AnswerKind::Point:
      return validatePoint(item, response);
    case AnswerKind::Number:
      return validateNumber(item, response);
    case AnswerKind::Option:
      return validateChoice(item, response, alternatives);
    case AnswerKind::Options:
      return validateChoices(item, response, alternatives);
    case AnswerKind::Text:
      return validateText(item, response);
  }
  return "the item has no known type";
}

}  // namespace questionnaires
