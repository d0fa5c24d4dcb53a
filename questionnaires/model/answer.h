#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "questionnaires/model/instrument.h"

namespace questionnaires {

/// What was answered: a point of a scale; a number; an option's id or a text; several options' ids.
using Response = std::variant<std::int64_t, double, std::string, std::vector<std::string>>;

/// An item and what was answered to it. Nothing, where it was not.
struct Answer {
  std::string itemId;
  std::optional<Response> response;
};

/// Why @p response is no valid answer to @p item, in words; std::nullopt if it is.
///
/// Alternatives are those that @p alternatives lists, where the item takes its options from there.
/// Texts may hold any Unicode but the character NUL; a short one has one line.
std::optional<std::string> validationError(
    const Item& item, const Response& response, const std::vector<std::string>& alternatives = {});

/// What @p response is called in @p language: the label of a point or an option, the word at the
/// end of a slider, the labels of several options with "; " between them; empty where it has none.
std::string labelOf(const Item& item, const Response& response, std::string_view language);

/// The value that is scored: a reverse-keyed item (key -1) gives low + high - x.
std::int64_t keyed(const Item& item, std::int64_t point) noexcept;

/// Whether @p item, one of @p items, is asked after @p answers: an item with a condition is asked
/// where the item it names is itself asked, and one of the options it lists was chosen there. An
/// answer that is there twice counts as the last of them.
bool isAsked(const Item& item, const std::vector<Item>& items, const std::vector<Answer>& answers);

/// The required items among @p items that are asked and have no answer in @p answers, or an empty
/// one: a blank text, no option of several. Who may choose none of them is offered that as an
/// option.
std::vector<std::string> unanswered(
    const std::vector<Item>& items, const std::vector<Answer>& answers);

/// The answer to @p item as a number, as it was given: the last one where there are several.
/// std::nullopt if there is none, where it was taken back, where validationError() refuses it, and
/// where answers to the item are no numbers.
std::optional<double> answerAsNumber(const Item& item, const std::vector<Answer>& answers);

/// @p number as it counts for @p item: low + high - x where the key is -1. A number item has no
/// key and is left alone.
double keyedNumber(const Item& item, double number);

}  // namespace questionnaires
