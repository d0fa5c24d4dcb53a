#include "questionnaires/model/instrument.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>

#include "questionnaires/json/document.h"

namespace questionnaires {

const std::string& LocalizedText::in(std::string_view language) const {
  static const std::string kNothing;
  auto found = byLanguage_.find(std::string(language));
  if (found == byLanguage_.end()) found = byLanguage_.find("en");
  return found == byLanguage_.end() ? kNothing : found->second;
}

namespace {

/// Edits (insert, delete, replace, swap of neighbours) that lead from one word to the other.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replace});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::string kindOf(const Value& value) {
  switch (value.data.index()) {
    case 0:
      return "null";
    case 1:
      return "true or false";
    case 2:
    case 3:
      return "a number";
    case 4:
      return "a text";
    case 5:
      return "a list";
    default:
      return "an object";
  }
}

std::string inWords(double value) {
  constexpr double kLargest = 1e15;  // beyond it a row of digits says nothing
  if (std::abs(value) > kLargest) return "any size";
  std::array<char, 64> digits{};
  const auto end = std::to_chars(digits.begin(), digits.end(), value, std::chars_format::fixed);
  return end.ec == std::errc() ? std::string(digits.begin(), end.ptr) : std::to_string(value);
}

std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 80;
  const auto isInsideCharacter = [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
  };
  std::size_t end = std::min(text.size(), kLongest);
  while (end > 0 && end < text.size() && isInsideCharacter(text[end])) --end;
  std::string result(text.substr(0, end));
  const bool isSound = charactersIn(result).has_value();
  const auto isOdd = [&](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7f || (byte > 0x7f && !isSound);
  };
  std::replace_if(result.begin(), result.end(), isOdd, '?');
  return end < text.size() ? result + "…" : result;
}

bool isSoundId(std::string_view id) noexcept {
  const auto letterOrDigit = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  };
  constexpr std::size_t kLongest = 64;
  return !id.empty() && id.size() <= kLongest && letterOrDigit(id.front()) &&
         std::all_of(id.begin(), id.end(), [&](char c) {
           return letterOrDigit(c) || c == '.' || c == '_' || c == '-';
         });
}

std::optional<std::string_view> nearest(
    std::string_view word, std::span<const std::string_view> known) {
  constexpr std::size_t kLongestWord = 64;
  if (word.size() > kLongestWord) return std::nullopt;
  std::optional<std::string_view> best;
  std::size_t fewest = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const auto name : known) {
    const std::size_t longer = std::max(word.size(), name.size());
    if (longer - std::min(word.size(), name.size()) >= fewest) continue;
    const std::size_t edits = editDistance(word, name);
    if (edits < fewest && edits < longer) {
      fewest = edits;
      best = name;
    }
  }
  return best;
}

std::optional<Range> rangeOf(const Item& item) noexcept {
  switch (item.type) {
    case ItemType::Likert:
    case ItemType::SemanticDifferential:
      return Range{
          static_cast<double>(item.scale.lowest), static_cast<double>(item.scale.highest())};
    case ItemType::Slider:
    case ItemType::Number:
      return Range{item.least, item.most};
    default:
      return std::nullopt;
  }
}

std::string_view nameOf(ItemType type) noexcept {
  for (const auto& known : kItemTypes) {
    if (known.value == type) return known.name;
  }
  return {};
}

bool Item::withholds(WordingField field) const noexcept {
  return std::find(withheld.begin(), withheld.end(), field) != withheld.end();
}

const Item* Instrument::item(std::string_view itemId) const noexcept {
  const auto found = std::find_if(
      items.begin(), items.end(), [&](const Item& candidate) { return candidate.id == itemId; });
  return found == items.end() ? nullptr : &*found;
}

const Score* Instrument::score(std::string_view scoreId) const noexcept {
  const auto found = std::find_if(scores.begin(), scores.end(), [&](const Score& candidate) {
    return candidate.id == scoreId;
  });
  return found == scores.end() ? nullptr : &*found;
}

bool Instrument::isWithheld() const noexcept {
  return std::any_of(
      items.begin(), items.end(), [](const Item& item) { return !item.withheld.empty(); });
}

std::vector<Item> Instrument::itemsOf(std::string_view set) const {
  std::vector<Item> result;
  std::copy_if(items.begin(), items.end(), std::back_inserter(result), [&](const Item& candidate) {
    return set.empty() || candidate.set == set;
  });
  return result;
}

}  // namespace questionnaires
