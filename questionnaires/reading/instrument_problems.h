#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "base/message.h"
#include "questionnaires/json/problem.h"
#include "questionnaires/model/instrument.h"

namespace questionnaires {

/// Warnings for an instrument's author ("key"), and advice on each ("key.fix").
inline constexpr auto kWarnings = std::to_array<base::MessageKind>({
    {"compares_with_previous", "this compares with what was felt just before"},
    {"compares_with_previous.fix",
     "an order must give it a predecessor: whatever is felt first has none"},
    {"different_ranges", "these items are answered on different ranges"},
    {"different_ranges.fix", "the widest weighs most: is that meant?"},
    {"some_pairs_asked", "{} of the {} pairs are asked"},
    {"some_pairs_asked.fix", "some items can gather more weight than others: is that meant?"},
    {"language_not_listed", "a text in '{}', which is not among the languages of the instrument"},
    {"language_not_listed.fix", "add '{}' to $.languages, or remove the text"},
    {"texts_not_listed",
     "{} texts are in '{}', which is not among the languages of the instrument"},
    {"same_text", "'{}' has the same text"},
    {"same_text.fix", "tell the two items apart"},
    {"same_ends", "both ends of the scale read the same"},
    {"same_ends.fix", "write what each end means"},
    {"blank_left", "still to be filled in: {}"},
    {"blank_left.fix", "write it into 'texts' of the protocol, or into this file"},
});

/// A warning of kWarnings with its arguments.
template <typename... Arguments>
base::Message warning(
    base::CheckedKey<kWarnings, sizeof...(Arguments)> key, Arguments&&... arguments) {
  return base::messageOf<kWarnings>(key, std::forward<Arguments>(arguments)...);
}

/// A text of an instrument that participants see, with a unique name.
struct TextPlace {
  std::string name;  ///< "title", "scale/low_label", "items/1/text"
  /// Pointers to the text and its copies: a scale that several items share has a copy in each item.
  std::vector<LocalizedText*> texts;
};

/// All texts of @p instrument that participants see, including withheld ones, in the order in which
/// they are shown. The pointers are valid until the instrument is changed or moved.
std::vector<TextPlace> textPlacesOf(Instrument& instrument);

/// The placeholders in @p text, separated by commas: "[[a]], [[b]]".
std::string placeholdersOf(const std::string& text);

/// Checks that the texts of an instrument exist in all required languages.
class TextCheck {
 public:
  /// Both arguments must outlive this object.
  TextCheck(const std::vector<std::string>& languages, Problems& problems)
      : languages_(languages), problems_(problems) {}

  /// Reports a text that participants see if it is missing in English or in a language of the
  /// instrument.
  void inspect(const std::string& path, const LocalizedText& text) const;

  /// Reports a text that only researchers read if it is missing in English.
  void inspectResearcherText(const std::string& path, const LocalizedText& text) const;

 private:
  /// Reports @p text as missing if it lacks @p language.
  void requireLanguage(
      const std::string& path, const LocalizedText& text, const std::string& language) const;
  /// Reports languages of @p text that the instrument does not list.
  void inspectLanguages(const std::string& path, const LocalizedText& text) const;

  const std::vector<std::string>& languages_;
  Problems& problems_;
};

/// Adds the problems of @p item, which is at @p path ("$.items[3]") of @p instrument.
void inspectItem(
    const Instrument& instrument, const Item& item, const std::string& path, Problems& problems);

/// Adds the problems of a scale.
void inspectScale(
    const Scale& scale, const std::string& path, const TextCheck& texts, Problems& problems);

/// Adds the problems of @p score, which is at @p path ("$.scores[0]") of @p instrument.
void inspectScore(
    const Instrument& instrument, const Score& score, const std::string& path, Problems& problems);

/// Adds the problems of the consistency rule of @p instrument, if it has one.
void inspectConsistency(const Instrument& instrument, Problems& problems);

}  // namespace questionnaires
