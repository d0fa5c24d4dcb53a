#include "questionnaires/reading/wording.h"

#include <set>

#include "base/search.h"
#include "base/text_table.h"
#include "questionnaires/json/document.h"
#include "questionnaires/reading/instrument_problems.h"

namespace questionnaires {
namespace {

/// Checks that @p wording belongs to this version of @p instrument.
void inspectHead(const Wording& wording, const Instrument& instrument, Problems& problems) {
  if (wording.instrument != instrument.id) {
    problems.add(
        "$.instrument",
        "these are the words of '" + shown(wording.instrument) + "', not of '" + instrument.id +
            "'",
        "put the file into the folder of its instrument");
  }
  if (wording.version != instrument.version) {
    problems.add(
        "$.version",
        "these words were written for version " + shown(wording.version) +
            ", and this is version " + instrument.version,
        "compare the items, then correct the version");
  }
  for (const auto& [id, key] : wording.keys) {
    const Item* item = instrument.item(id);
    if (item != nullptr && item->key == key) continue;
    problems.add(
        "$.keys." + shown(id),
        item == nullptr ? "there is no such item" : "the instrument has the other key",
        "write the template again: are these the same items in the same order?");
  }
}

void inspectTexts(const Wording& wording, const Instrument& instrument, Problems& problems) {
  const auto missing = missingTexts(instrument, wording.language);
  for (const auto& place : missing) {
    const auto text = wording.texts.find(place);
    const bool isThere = text != wording.texts.end() && !base::isBlank(text->second);
    if (isThere && text->second.find("[[") == std::string::npos) continue;
    problems.add(
        "$.texts." + place,
        isThere ? "a placeholder is left" : "this text is still empty",
        "write the published words");
  }
  const std::set<std::string> known(missing.begin(), missing.end());
  for (const auto& [place, text] : wording.texts) {
    if (known.count(place) > 0) continue;
    problems.add(
        "$.texts." + shown(place),
        "the instrument asks for no such text in '" + wording.language + "'",
        "remove it; a text that ships is changed in a copy of the instrument");
  }
}

/// Removes @p language and all texts in it from @p instrument.
void removeLanguage(const std::string& language, Instrument& instrument) {
  const auto remove = [&](LocalizedText& text) {
    auto texts = text.all();
    texts.erase(language);
    text = LocalizedText(std::move(texts));
  };
  for (const auto& place : textPlacesOf(instrument)) {
    for (auto* text : place.texts) remove(*text);
  }
  for (auto& score : instrument.scores) remove(score.title);
  auto& languages = instrument.languages;
  std::erase(languages, language);
}

void reportMissingWording(
    const Instrument& instrument,
    const std::string& language,
    const std::string& path,
    Problems& problems) {
  const std::string file = wordingFileName(instrument.id, language);
  problems.add(
      path,
      "the words of '" + instrument.id + "' do not come with Palpate, and there is no file '" +
          file + "' with them",
      "write it with 'palpate instrument wording " + instrument.id + " --language " + language +
          " --out " + file + "', in the folder of the protocol, and fill in the words; they are " +
          "to be had here: " + instrument.source.wordingFrom);
}

/// Adds the wording file of one language; false if the file does not exist.
bool addWording(
    Instrument& instrument,
    const std::string& language,
    const WordingFinder& find,
    Problems& problems) {
  const std::string file = wordingFileName(instrument.id, language);
  const auto json = find(file);
  if (!json) return false;
  Problems inFile;
  const auto wording = readWording(*json, inFile);
  if (wording && wording->language != language) {
    inFile.add(
        "$.language",
        "these words are in '" + shown(wording->language) + "'",
        "name the file after its language");
  } else if (wording) {
    applyWording(*wording, instrument, inFile);
  }
  for (auto problem : inFile.all()) {
    problem.path = file + " " + problem.path;
    problem.severity = Severity::Error;
    problems.add(std::move(problem));
  }
  return true;
}

}  // namespace

std::string wordingFileName(const std::string& id, const std::string& language) {
  return "wording/" + id + "/" + language + ".json";
}

std::vector<std::string> missingTexts(const Instrument& instrument, const std::string& language) {
  Instrument copy = instrument;
  std::vector<std::string> missing;
  for (const auto& place : textPlacesOf(copy)) {
    if (!place.texts.front()->has(language)) missing.push_back(place.name);
  }
  return missing;
}

void applyWording(const Wording& wording, Instrument& instrument, Problems& problems) {
  Problems found;
  inspectHead(wording, instrument, found);
  inspectTexts(wording, instrument, found);
  problems.append(found);
  if (found.hasErrors()) return;
  for (const auto& place : textPlacesOf(instrument)) {
    const auto words = wording.texts.find(place.name);
    if (words == wording.texts.end()) continue;
    for (auto* text : place.texts) {
      auto texts = text->all();
      texts[wording.language] = words->second;
      *text = LocalizedText(std::move(texts));
    }
  }
  auto& languages = instrument.languages;
  if (!base::contains(languages, wording.language)) languages.push_back(wording.language);
}

void completeWording(
    Instrument& instrument,
    const std::vector<std::string>& additionalLanguages,
    const WordingFinder& find,
    const std::string& path,
    Problems& problems) {
  std::vector<std::string> languages = instrument.languages;
  for (const auto& language : additionalLanguages) {
    if (!base::contains(languages, language)) languages.push_back(language);
  }
  for (const auto& language : languages) {
    if (missingTexts(instrument, language).empty()) continue;
    if (addWording(instrument, language, find, problems)) continue;
    if (language == "en") {
      reportMissingWording(instrument, language, path, problems);
    } else if (base::contains(instrument.languages, language)) {
      removeLanguage(language, instrument);
    }
  }
}

}  // namespace questionnaires
