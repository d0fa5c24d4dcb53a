#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "questionnaires/json/document.h"
#include "questionnaires/model/instrument.h"

namespace questionnaires {

/// Reads texts that may stand in several languages: "…" for English, or {"en": "…", "de": "…"}.
///
/// What cannot be read is a problem once, and a dash in every language stands in for it: so that
/// problemsOf(), which looks at the instrument afterwards, reports no place that has a problem
/// already.
class TextReader {
 public:
  explicit TextReader(std::vector<std::string> languages) : languages_(std::move(languages)) {}

  LocalizedText required(const Node& node, std::string_view key) const;
  /// Empty where the key is missing.
  LocalizedText optional(const Node& node, std::string_view key) const;
  /// Reads @p node as a text, or as an object with a text for each language.
  LocalizedText read(const Node& node) const;
  LocalizedText fallbackText() const;

 private:
  std::vector<std::string> languages_;
};

/// Whether @p tag is a language tag as this format knows them: "en", "nb", "de-CH".
bool isLanguageTag(std::string_view tag) noexcept;

/// The scale that @p node describes. Where only the points are labelled, the first and the last of
/// their labels are those of the ends.
Scale readScale(const Node& node, const TextReader& texts);

/// A placeholder for a scale that could not be read.
Scale defaultScale(const TextReader& texts);

/// What stands for a number that could not be read.
inline constexpr double kUnread = std::numeric_limits<double>::quiet_NaN();

/// Reads the items of an instrument.
///
/// Every type of item has keys of its own; a key of another type is refused and named as such. What
/// cannot be read is stood in for by something that problemsOf() has nothing to say about.
class ItemReader {
 public:
  /// @param scale  of the items that bring none of their own
  ItemReader(TextReader texts, std::optional<Scale> scale)
      : texts_(std::move(texts)), scale_(std::move(scale)) {}

  /// The item that @p node describes, the one with number @p index.
  Item read(const Node& node, std::size_t index) const;

 private:
  void readCommonKeys(const Node& node, Item& item) const;
  void readKind(const Node& node, Item& item) const;
  void readScaleOf(const Node& node, Item& item) const;
  void readEnds(const Node& node, Item& item) const;
  LocalizedText readText(const Node& node, std::string_view key, bool isWithheld) const;
  void readOptions(const Node& node, Item& item) const;
  Option readOption(const Node& node, std::size_t index) const;

  TextReader texts_;
  std::optional<Scale> scale_;
};

/// The id behind @p key, or, if there is none, one that no other has.
std::string idOrGenerated(const Node& node, std::string_view key, std::size_t index);

/// The score that @p node describes, the one with number @p index.
Score readScore(const Node& node, const TextReader& texts, std::size_t index);

/// The rule that @p node describes; what cannot be read of it is a problem, and left as it is.
ConsistencyRule readConsistencyRule(const Node& node);

}  // namespace questionnaires
