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

/// Reads texts in one or several languages: "…" in English, or {"en": "…", "de": "…"}.
///
/// A text that cannot be read gets one problem and is replaced by a dash in every language, so that
/// problemsOf(), which checks the instrument afterwards, does not report it again.
class TextReader {
 public:
  explicit TextReader(std::vector<std::string> languages) : languages_(std::move(languages)) {}

  /// The text at @p key; a missing key is a problem.
  LocalizedText required(const Node& node, std::string_view key) const;
  /// Empty if the key is missing.
  LocalizedText optional(const Node& node, std::string_view key) const;
  /// Reads @p node as a text, or as an object with a text for each language.
  LocalizedText read(const Node& node) const;
  /// A dash in every language.
  LocalizedText fallbackText() const;

 private:
  std::vector<std::string> languages_;
};

/// Whether @p tag is a language tag of the form "en", "nb" or "de-CH".
bool isLanguageTag(std::string_view tag) noexcept;

/// Adds a problem if @p language, which stands at @p node, is no language tag; returns whether it
/// is one.
bool requireLanguageTag(const Node& node, std::string_view key, std::string_view language);

/// The language tags in a list. Other entries and repeated ones are problems, and left out.
std::vector<std::string> languagesIn(const std::vector<Node>& list);

/// Reads a scale. If only points have labels, the first and the last of these are the labels of the
/// ends.
Scale readScale(const Node& node, const TextReader& texts);

/// A scale that replaces one that could not be read.
Scale defaultScale(const TextReader& texts);

/// Replaces a number that could not be read.
inline constexpr double kUnreadNumber = std::numeric_limits<double>::quiet_NaN();

/// Reads the items of an instrument.
///
/// Each type of item has its own keys; a key of another type is refused with a message on that
/// type. Values that cannot be read are replaced by values about which problemsOf() reports
/// nothing.
class ItemReader {
 public:
  /// @param scale  scale of items that have none of their own
  ItemReader(TextReader texts, std::optional<Scale> scale)
      : texts_(std::move(texts)), scale_(std::move(scale)) {}

  /// Reads the item at index @p index.
  Item read(const Node& node, std::size_t index) const;

 private:
  void readCommonKeys(const Node& node, Item& item) const;
  /// Reads the keys of the item's type that readCommonKeys() does not read.
  void readKeysOfType(const Node& node, Item& item) const;
  /// Reads the item's scale; without one, copies the instrument's.
  void readScaleOf(const Node& node, Item& item) const;
  /// Reads the labels of the low and the high end.
  void readEndLabels(const Node& node, Item& item) const;
  LocalizedText readText(const Node& node, std::string_view key, bool isWithheld) const;
  void readOptions(const Node& node, Item& item) const;
  Option readOption(const Node& node, std::size_t index) const;

  TextReader texts_;
  std::optional<Scale> scale_;
};

/// Reads the id at @p key; without a valid id, returns a unique generated one.
std::string idOrGenerated(const Node& node, std::string_view key, std::size_t index);

/// Reads the score at index @p index.
Score readScore(const Node& node, const TextReader& texts, std::size_t index);

/// Reads a consistency rule. A value that cannot be read is a problem; its default is kept.
ConsistencyRule readConsistencyRule(const Node& node);

}  // namespace questionnaires
