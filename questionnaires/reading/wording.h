#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "questionnaires/model/instrument.h"

namespace questionnaires {

/// The texts of an instrument in one language, as a researcher copied them from their publication:
/// texts that may not be shipped with the instrument, or a translation that it lacks.
struct Wording {
  std::string instrument;
  std::string version;   ///< version of the instrument that the texts are for
  std::string language;  ///< "en"
  std::string source;    ///< publication that the researcher copied
  /// By TextPlace::name: "items/1/text", "scale/low_label".
  std::map<std::string, std::string> texts;
  /// Scoring keys by item: 1, or -1 for a reversed item. Compared with those of the instrument; may
  /// be empty.
  std::map<std::string, int> keys;
};

/// Reads a wording file (docs/questionnaire-format.md); std::nullopt, with problems, if it has
/// errors. Empty texts are kept as empty.
std::optional<Wording> readWording(std::string_view json, Problems& problems);

/// A wording file for @p language without the texts: names of the missing texts, keys of the items,
/// and the source where the texts can be found.
std::string wordingTemplate(const Instrument& instrument, const std::string& language);

/// The name of the wording file of the instrument @p id, relative to the folder of the protocol or
/// the instrument: "wording/sus/en.json".
std::string wordingFileName(const std::string& id, const std::string& language);

/// The names (TextPlace::name) of the texts that @p instrument lacks in @p language, in the order
/// in which a participant reads them.
std::vector<std::string> missingTexts(const Instrument& instrument, const std::string& language);

/// Adds the texts and the language of @p wording to @p instrument, if it contains exactly the
/// missing texts. Otherwise adds problems and changes nothing.
void apply(const Wording& wording, Instrument& instrument, Problems& problems);

/// Finds the text of the wording file called @p name; std::nullopt if there is none.
using WordingFinder = std::function<std::optional<std::string>(const std::string& name)>;

/// Searches for wording files of @p instrument in English, in its languages and in @p alsoIn, and
/// adds their texts.
///
/// English must be complete, because it is shown if another language has no text. A language of the
/// instrument whose withheld texts are not found is removed from it. A wording file with errors is
/// a problem in any language. The paths of problems begin with the file's name; @p path is the
/// place that names the instrument.
void completeWording(
    Instrument& instrument,
    const std::vector<std::string>& alsoIn,
    const WordingFinder& find,
    const std::string& path,
    Problems& problems);

}  // namespace questionnaires
