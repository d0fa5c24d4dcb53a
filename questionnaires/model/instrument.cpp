#include "questionnaires/model/instrument.h"

#include <algorithm>

#include "base/search.h"
#include "questionnaires/json/document.h"

namespace questionnaires {

const std::string& LocalizedText::in(std::string_view language) const {
  static const std::string kNothing;
  auto found = byLanguage_.find(std::string(language));
  if (found == byLanguage_.end()) found = byLanguage_.find("en");
  return found == byLanguage_.end() ? kNothing : found->second;
}

std::optional<Range> rangeOf(const Item& item) noexcept {
  switch (answerKindOf(item.type)) {
    case AnswerKind::Point:
      return Range{
          static_cast<double>(item.scale.lowest), static_cast<double>(item.scale.highest())};
    case AnswerKind::Number:
      return Range{item.least, item.most};
    case AnswerKind::Option:
    case AnswerKind::Options:
    case AnswerKind::Text:
      break;
  }
  return std::nullopt;
}

std::string_view nameOf(ItemType type) noexcept {
  return kItemTypes[static_cast<std::size_t>(type)].name;
}

AnswerKind answerKindOf(ItemType type) noexcept {
  return kItemTypes[static_cast<std::size_t>(type)].answer;
}

bool Item::withholds(WordingField field) const noexcept {
  return base::contains(withheld, field);
}

const Item* Instrument::item(std::string_view itemId) const noexcept {
  return base::withId(items, itemId);
}

const Score* Instrument::score(std::string_view scoreId) const noexcept {
  return base::withId(scores, scoreId);
}

bool Instrument::hasWithheldTexts() const noexcept {
  return std::ranges::any_of(items, [](const Item& item) { return !item.withheld.empty(); });
}

std::vector<Item> Instrument::itemsOf(std::string_view set) const {
  std::vector<Item> result;
  std::ranges::copy_if(items, std::back_inserter(result), [&](const Item& candidate) {
    return set.empty() || candidate.set == set;
  });
  return result;
}

}  // namespace questionnaires
