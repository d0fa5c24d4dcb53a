#pragma once

#include <string>
#include <vector>

#include "questionnaires/json/problem.h"
#include "questionnaires/model/instrument.h"
#include "questionnaires/model/localized_text.h"

namespace questionnaires {

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

/// Whatever of @p text stands in double square brackets, one after the other: "[[a]], [[b]]".
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
  void inspectWhatIsThere(const std::string& path, const LocalizedText& text) const;

  const std::vector<std::string>& languages_;
  Problems& problems_;
};

}  // namespace questionnaires
