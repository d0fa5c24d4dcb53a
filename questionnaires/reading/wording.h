#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "questionnaires/model/instrument.h"

namespace questionnaires {

/// The texts of an instrument in one language, as a researcher copied them from a publication:
/// texts that may not be shipped with the instrument, or a translation that the instrument lacks.
struct Wording {
  std::string instrument;
  std::string version;   ///< version of the instrument to which the texts belong
  std::string language;  ///< "en"
  std::string source;    ///< publication from which the researcher copied
  /// By TextPlace::name: "items/1/text", "scale/low_label".
  std::map<std::string, std::string> texts;
  /// Scoring keys by item id: 1, or -1 for a reversed item. They are compared with those of the
  /// instrument; may be empty.
  std::map<std::string, int> keys;
};

/// Reads a wording file (docs/questionnaire-format.md); std::nullopt, with problems, if there are
/// errors. Empty texts are kept.
std::optional<Wording> readWording(std::string_view json, Problems& problems);

/// A wording file for @p language to be filled in: names of the missing texts, keys of the items,
/// and the source in which the texts can be found.
std::string wordingTemplate(const Instrument& instrument, const std::string& language);

/// The name of the wording file of the instrument @p id, relative to the folder of the protocol or
/// the instrument: "wording/sus/en.json".
std::string wordingFileName(const std::string& id, const std::string& language);

/// The names (TextPlace::name) of the texts that @p instrument lacks in @p language, in the order
/// in which a participant reads them.
std::vector<std::string> missingTexts(const Instrument& instrument, const std::string& language);

/// Adds the texts and the language of @p wording to @p instrument, if @p wording has exactly the
/// missing texts. Otherwise adds problems and changes nothing.
void applyWording(const Wording& wording, Instrument& instrument, Problems& problems);

/// Returns the text of the wording file called @p name; std::nullopt if it does not exist.
using WordingFinder = std::function<std::optional<std::string>(const std::string& name)>;

/// Searches for wording files of @p instrument in English, in its languages and in @p
/// additionalLanguages, and adds their texts.
///
/// English must be complete, because it is shown in place of missing texts. A language of the
/// instrument whose withheld texts are not found is removed. A wording file with errors is a
/// problem in any language. The paths of problems begin with the file's name; problems of missing
/// files are at @p path, the place that refers to the instrument.
void completeWording(
    Instrument& instrument,
    const std::vector<std::string>& additionalLanguages,
    const WordingFinder& find,
    const std::string& path,
    Problems& problems);

}  // namespace questionnaires
