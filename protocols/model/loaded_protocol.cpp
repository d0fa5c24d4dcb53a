#include "protocols/model/loaded_protocol.h"

#include <algorithm>
#include <set>
#include <utility>

#include "base/joined.h"
#include "base/search.h"
#include "protocols/model/messages.h"
#include "protocols/model/protocol.h"
#include "questionnaires/reading/instrument_problems.h"

namespace protocols {

std::string describeOrigin(const SceneDataSource& source) {
  return base::joined(source.origin, ", ", [](const auto& part) { return base::describe(part); });
}

std::string describe(const SceneDataSource& source) {
  std::string words = source.isSynthetic ? "SYNTHETIC: " : "";
  words += base::describe(source.title) + " (" + source.kind;
  words += source.file.empty() ? ", built into the program)" : " '" + source.file + "')";
  return source.origin.empty() ? words : words + ", " + describeOrigin(source);
}

const questionnaires::Instrument* LoadedProtocol::instrument(std::string_view id) const noexcept {
  return base::withId(instruments, id);
}

namespace {

using questionnaires::LocalizedText;
using Texts = std::vector<const LocalizedText*>;

std::string placeholderTexts(const Texts& texts, const std::string& language) {
  std::string words;
  std::set<std::string> seen;  // without duplicates, because items of one scale repeat its texts
  for (const auto* text : texts) {
    const std::string more = questionnaires::placeholdersOf(text->in(language));
    if (!more.empty() && seen.insert(more).second) words += (words.empty() ? "" : ", ") + more;
  }
  return words;
}

/// Adds the placeholders in @p texts to @p found as one entry, in all languages that a participant
/// can choose.
void findPlaceholders(
    std::vector<Placeholder>& found,
    const std::string& where,
    const Texts& texts,
    const std::vector<std::string>& languages) {
  Placeholder placeholder;
  std::string affectedLanguages;
  for (const auto& language : languages) {
    const auto words = placeholderTexts(texts, language);
    if (words.empty()) continue;
    affectedLanguages += (affectedLanguages.empty() ? "" : ", ") + language;
    if (placeholder.words.empty()) placeholder.words = words;
  }
  if (placeholder.words.empty()) return;
  placeholder.where = where + " (" + affectedLanguages + ")";
  found.push_back(std::move(placeholder));
}

void replaceAll(std::string& text, std::string_view place, const std::string& words) {
  for (auto at = text.find(place); at != std::string::npos; at = text.find(place, at)) {
    text.replace(at, place.size(), words);
    at += words.size();
  }
}

bool isCapital(char letter) noexcept {
  return letter >= 'A' && letter <= 'Z';
}

/// A label as it is written inside a sentence: "tissue" for "Tissue"; "FEM" is unchanged.
std::string asInsideSentence(std::string label) {
  const bool isAbbreviation = label.size() > 1 && isCapital(label[1]);
  if (!label.empty() && isCapital(label[0]) && !isAbbreviation) {
    label[0] = static_cast<char>(label[0] - 'A' + 'a');
  }
  return label;
}

void fillIn(LocalizedText& text, const LocalizedText& label) {
  auto words = text.all();
  for (auto& [language, sentence] : words) {
    replaceAll(sentence, "{Label}", label.in(language));
    replaceAll(sentence, "{label}", asInsideSentence(label.in(language)));
  }
  text = LocalizedText(std::move(words));
}

}  // namespace

void fillInLabels(LoadedProtocol& loaded) {
  const auto& label = loaded.protocol.labels.prefix;
  for (auto& instrument : loaded.instruments) {
    for (const auto& place : questionnaires::textPlacesOf(instrument)) {
      for (auto* text : place.texts) fillIn(*text, label);
    }
  }
  for (auto& phase : loaded.protocol.phases) {
    fillIn(phase.text, label);
    auto words = phase.text.all();
    for (auto& [language, sentence] : words) {
      replaceAll(sentence, "{minimum_cuts}", std::to_string(phase.minimumCuts));
    }
    phase.text = LocalizedText(std::move(words));
  }
}

std::vector<Placeholder> unfilledPlaceholdersIn(const LoadedProtocol& loaded) {
  std::vector<Placeholder> found;
  const auto& protocol = loaded.protocol;
  findPlaceholders(found, "$.labels.prefix", {&protocol.labels.prefix}, protocol.languages);
  for (std::size_t i = 0; i < protocol.phases.size(); ++i) {
    const std::string where = "$.phases[" + std::to_string(i) + "].text";
    findPlaceholders(found, where, {&protocol.phases[i].text}, protocol.languages);
  }
  std::set<std::string> seen;
  for (const auto& use : instrumentUses(protocol)) {
    if (!seen.insert(use.instrument).second) continue;
    auto instrument = *loaded.instrument(use.instrument);
    Texts texts;
    for (const auto& place : questionnaires::textPlacesOf(instrument)) {
      texts.insert(texts.end(), place.texts.begin(), place.texts.end());
    }
    findPlaceholders(found, use.instrument, texts, protocol.languages);
  }
  return found;
}

namespace {

/// The blanks of the shipped texts, in the order in which a form asks for them.
std::vector<std::pair<std::string_view, base::Message>> knownBlanks() {
  return {
      {"institution", message("blank.institution")},
      {"contact", message("blank.contact")},
      {kDurationBlank, message("blank.duration")},
      {"ethics", message("blank.ethics")},
      {"delete_until", message("blank.delete_until")},
      {"names_seen_by", message("blank.names_seen_by")},
      {"names_destroyed", message("blank.names_destroyed")},
      {"data_kept_years", message("blank.data_kept_years")},
      {"data_protection_officer", message("blank.data_protection_officer")},
      {"data_protection_authority", message("blank.data_protection_authority")},
  };
}

}  // namespace

std::vector<Blank> blanksOf(const LoadedProtocol& loaded) {
  std::vector<Blank> blanks;
  const auto add = [&](const std::string& key, const base::Message& title) {
    const auto text = loaded.protocol.texts.find(key);
    const bool isFilled = text != loaded.protocol.texts.end();
    blanks.push_back({key, title, isFilled ? text->second : LocalizedText()});
  };
  const auto known = knownBlanks();
  for (const auto& [key, title] : known) {
    if (base::contains(loaded.blanks, key)) add(std::string(key), title);
  }
  for (const auto& key : loaded.blanks) {
    const bool isKnown =
        std::ranges::any_of(known, [&](const auto& one) { return one.first == key; });
    if (!isKnown) add(key, message("blank.own", key));
  }
  return blanks;
}

}  // namespace protocols
