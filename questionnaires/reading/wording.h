#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "questionnaires/model/instrument.h"

namespace questionnaires {

/// The words of an instrument in one language, as a researcher copied them from where they were
/// published: what the instrument itself may not ship, or a translation that it lacks.
struct Wording {
  std::string instrument;
  std::string version;                       ///< of the instrument that they were written for
  std::string language;                      ///< "en"
  std::string source;                        ///< where the researcher took them from
  std::map<std::string, std::string> texts;  ///< by place: "items/1/text", "scale/low_label"
  std::map<std::string, int> keys;           ///< of the items, to be compared; may be empty
};

/// Reads a wording file (docs/questionnaire-format.md); nothing, and problems, where it has errors.
/// Texts that are still empty are read as such.
std::optional<Wording> readWording(std::string_view json, Problems& problems);

/// A wording file for @p language with everything but the words: the places whose text is missing,
/// the keys of the items, and where the words are to be had.
std::string wordingTemplate(const Instrument& instrument, const std::string& language);

/// Where the wording of the instrument called @p id is looked for: "wording/sus/en.json", beside
/// the protocol or the instrument.
std::string wordingFileName(const std::string& id, const std::string& language);

/// The places of the texts that @p instrument lacks in @p language, in the order in which a
/// participant reads them.
std::vector<std::string> missingTexts(const Instrument& instrument, const std::string& language);

/// Puts the texts of @p wording into @p instrument, and its language among the languages, if all
/// that is missing is there and nothing else is; otherwise adds what is wrong to @p problems and
/// changes nothing.
void apply(const Wording& wording, Instrument& instrument, Problems& problems);

/// Finds the text of the wording file called @p name; std::nullopt if there is none.
using WordingFinder = std::function<std::optional<std::string>(const std::string& name)>;

/// Looks for the wording of @p instrument in English, in its languages and in @p alsoIn, and puts
/// in what is found.
///
/// English has to be complete, since it is shown where another language has no text. A language of
/// the instrument whose withheld texts are nowhere is taken out of it; a wording file that is
/// there and has errors is a problem in any language. Problems have the file's name before the
/// path; @p path is where the instrument is named.
void completeWording(
    Instrument& instrument,
    const std::vector<std::string>& alsoIn,
    const WordingFinder& find,
    const std::string& path,
    Problems& problems);

}  // namespace questionnaires
