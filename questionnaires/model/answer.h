#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "questionnaires/model/instrument.h"

namespace questionnaires {

/// The value of an answer: a point of a scale, a number, the id of an option or a text, or the ids
/// of several options.
using Response = std::variant<std::int64_t, double, std::string, std::vector<std::string>>;

/// An answer to an item. The response is std::nullopt if the item was not answered.
struct Answer {
  std::string itemId;
  std::optional<Response> response;
};

/// The reason why @p response is not a valid answer to @p item, as a sentence; std::nullopt if it
/// is valid.
///
/// If the options of the item are alternatives, @p alternatives lists their ids. Texts may contain
/// any Unicode character except NUL; a short text has one line.
std::optional<std::string> validationError(
    const Item& item, const Response& response, const std::vector<std::string>& alternatives = {});

/// The label of @p response in @p language: of its point, its option, or its end of a slider;
/// several options are separated by "; ". Empty if there is no label.
std::string labelOf(const Item& item, const Response& response, std::string_view language);

/// The scored value of @p point, a point of the item's scale: low + high - point if the key of the
/// item is -1.
std::int64_t keyedPoint(const Item& item, std::int64_t point) noexcept;

/// The response of the last of @p answers to the item; nullptr if it was not answered.
const Response* lastResponse(std::string_view itemId, const std::vector<Answer>& answers);

/// Whether @p item, one of @p items, is asked after @p answers. An item with a condition (ShowIf)
/// is asked if the item in its condition was itself asked and answered with one of the listed
/// options. If an item was answered several times, the last answer counts.
bool isAsked(const Item& item, const std::vector<Item>& items, const std::vector<Answer>& answers);

/// The ids of required items among @p items that are asked but have no answer in @p answers, or an
/// empty one (a blank text, or no option selected). An item that allows "none" must offer it as an
/// option.
std::vector<std::string> unansweredItems(
    const std::vector<Item>& items, const std::vector<Answer>& answers);

/// The answer to @p item as a number, before reversal; the last one if there are several.
/// std::nullopt if the item was not answered, its answer was withdrawn or is not valid
/// (validationError()), or its answers are not numbers.
std::optional<double> answerAsNumber(const Item& item, const std::vector<Answer>& answers);

/// The scored value of @p number: low + high - x if the key of @p item is -1. Answers to a number
/// item, which has no key, are returned unchanged.
double keyedNumber(const Item& item, double number);

}  // namespace questionnaires
