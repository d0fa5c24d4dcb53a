#include <string>

#include <nlohmann/json.hpp>

#include "questionnaires/json/document.h"
#include "questionnaires/reading/instrument_reader.h"
#include "questionnaires/reading/wording.h"

namespace questionnaires {
namespace {

constexpr std::string_view kFormat = "wording-1";

void readKeys(const Node& root, Wording& wording) {
  root.requireFormat("format", kFormat);
  wording.instrument = root.id("instrument");
  wording.version = root.id("version");
  wording.language = root.text("language");
  if (!wording.language.empty()) requireLanguageTag(root, "language", wording.language);
  wording.source = root.text("source");
}

/// The publication in which the texts can be found, from the instrument's source.
std::string publicationOf(const Source& source) {
  std::string words = source.citation;
  if (!source.doi.empty()) words += " https://doi.org/" + source.doi;
  return source.wordingFrom.empty() ? words : words + " | " + source.wordingFrom;
}

Wording readWordingRoot(const Node& root) {
  Wording wording;
  if (!root.isObjectWithOnlyKeys(
          {"format",
           "instrument",
           "version",
           "language",
           "words_from",
           "source",
           "keys",
           "texts"})) {
    return wording;
  }
  readKeys(root, wording);
  root.text("words_from", "");
  if (const auto keys = root.object("keys")) {
    for (const auto& key : keys->members()) {
      wording.keys[key.first] = static_cast<int>(keys->wholeNumber(key.first, -1, 1));
    }
  }
  if (const auto texts = root.requiredObject("texts")) {
    for (const auto& [place, text] : texts->members()) wording.texts[place] = text.asText();
  }
  return wording;
}

}  // namespace

std::optional<Wording> readWording(std::string_view json, Problems& problems) {
  return readJson<Wording>(json, problems, readWordingRoot);
}

std::string wordingTemplate(const Instrument& instrument, const std::string& language) {
  nlohmann::ordered_json file;
  file["format"] = kFormat;
  file["instrument"] = instrument.id;
  file["version"] = instrument.version;
  file["language"] = language;
  file["words_from"] = publicationOf(instrument.source);
  file["source"] = "";
  file["keys"] = nlohmann::ordered_json::object();
  for (const auto& item : instrument.items) {
    if (!item.withheld.empty()) file["keys"][item.id] = item.key;
  }
  file["texts"] = nlohmann::ordered_json::object();
  for (const auto& place : missingTexts(instrument, language)) file["texts"][place] = "";
  return file.dump(2) + "\n";
}

}  // namespace questionnaires
