#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/message.h"
#include "questionnaires/json/problem.h"
#include "questionnaires/model/instrument.h"

namespace questionnaires {

/// What an instrument's author is warned of, and what to do about it: "key" and "key.fix".
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
    {"blank_left", "still to be filled in: {}"},
    {"blank_left.fix", "write it into 'texts' of the protocol, or into this file"},
});

/// One of them, with its arguments.
template <typename... Arguments>
base::Message warning(
    base::CheckedKey<kWarnings, sizeof...(Arguments)> key, Arguments&&... arguments) {
  return base::messageOf<kWarnings>(key, std::forward<Arguments>(arguments)...);
}

/// A text of an instrument that participants see, with a name that no other has.
struct TextPlace {
  std::string name;                   ///< "title", "scale/low_label", "items/1/text"
  std::vector<LocalizedText*> texts;  ///< the text and its copies: a common scale has many
};

/// The texts of @p instrument that participants see, in the order in which they do: those that are
/// there, and those that are withheld. Pointers are good as long as the instrument stays.
std::vector<TextPlace> textPlacesOf(Instrument& instrument);

/// Whether a text has nothing but spaces, tabs and line ends.
bool isBlank(const std::string& text);

/// The parts of @p text in double square brackets, one after the other: "[[a]], [[b]]".
std::string placeholdersOf(const std::string& text);

/// Looks over the texts of an instrument, language by language.
class TextProblems {
 public:
  /// Both outlive this.
  TextProblems(const std::vector<std::string>& languages, Problems& problems)
      : languages_(languages), problems_(problems) {}

  /// A text that participants see: there in English and in every language of the instrument.
  void inspect(const std::string& path, const LocalizedText& text) const;

  /// A text that only researchers see: there in English.
  void inspectForResearchers(const std::string& path, const LocalizedText& text) const;

 private:
  void demand(
      const std::string& path, const LocalizedText& text, const std::string& language) const;
  void inspectLanguages(const std::string& path, const LocalizedText& text) const;

  const std::vector<std::string>& languages_;
  Problems& problems_;
};

/// Adds to @p problems what is wrong with @p item, which stands at @p path ("$.items[3]") of
/// @p instrument.
void inspectItem(
    const Instrument& instrument, const Item& item, const std::string& path, Problems& problems);

/// The same for a scale.
void inspectScale(
    const Scale& scale, const std::string& path, const TextProblems& texts, Problems& problems);

/// Adds to @p problems what is wrong with @p score, which stands at @p path ("$.scores[0]") of
/// @p instrument.
void inspectScore(
    const Instrument& instrument, const Score& score, const std::string& path, Problems& problems);

/// The same for the consistency rule of @p instrument, where it has one.
void inspectConsistency(const Instrument& instrument, Problems& problems);

}  // namespace questionnaires
