#include "questionnaires/reading/text_problems.h"

#include <algorithm>
#include <utility>

namespace questionnaires {

bool isBlank(const std::string& text) {
  return text.find_first_not_of(" \t\r\n") == std::string::npos;
}

std::string placeholdersOf(const std::string& text) {
  std::string result;
  std::size_t start = text.find("[[");
  while (start != std::string::npos) {
    const std::size_t end = text.find("]]", start);
    if (end == std::string::npos) break;
    result += (result.empty() ? "" : ", ") + text.substr(start, end + 2 - start);
    start = text.find("[[", end);
  }
  return result;
}

void TextProblems::inspect(const std::string& path, const LocalizedText& text) const {
  demand(path, text, "en");
  for (const auto& language : languages_) {
    if (language != "en") demand(path, text, language);
  }
  inspectWhatIsThere(path, text);
}

void TextProblems::inspectForResearchers(const std::string& path, const LocalizedText& text) const {
  demand(path, text, "en");
  inspectWhatIsThere(path, text);
}

void TextProblems::demand(
    const std::string& path, const LocalizedText& text, const std::string& language) const {
  if (text.has(language)) return;
  std::string fix = "write something: English is shown where another language has no text";
  if (language != "en") {
    fix = "write {\"en\": \"…\", \"";
    fix.append(language).append("\": \"…\"}, or take '").append(language);
    fix.append("' out of $.languages");
  }
  problems_.add(path + "." + language, "the text in '" + language + "' is missing", std::move(fix));
}

void TextProblems::inspectWhatIsThere(const std::string& path, const LocalizedText& text) const {
  for (const auto& [language, words] : text.all()) {
    std::string place = path;
    place.append(".").append(language);
    if (isBlank(words)) problems_.add(place, "this text is blank", "write something");
    if (std::find(languages_.begin(), languages_.end(), language) == languages_.end()) {
      problems_.warn(
          place,
          "a text in '" + language + "', which is not among the languages of the instrument",
          "add '" + language + "' to $.languages, or remove the text");
    }
    const std::string placeholders = placeholdersOf(words);
    if (!placeholders.empty()) {
      problems_.warn(
          place,
          "still to be filled in: " + placeholders,
          "copy the instrument into the study's folder and write what holds there");
    }
  }
}

}  // namespace questionnaires
