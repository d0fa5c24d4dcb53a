#include "questionnaires/reading/blanks.h"

#include <algorithm>
#include <utility>

#include "questionnaires/reading/instrument_problems.h"

namespace questionnaires {

void BlankFiller::note(const std::string& key) {
  if (std::find(keys_.begin(), keys_.end(), key) == keys_.end()) keys_.push_back(key);
}

std::string BlankFiller::filled(const std::string& text, const std::string& language) {
  constexpr std::size_t kBrackets = 2;
  std::string result;
  std::size_t from = 0;
  for (auto start = text.find("[["); start != std::string::npos; start = text.find("[[", from)) {
    const auto end = text.find("]]", start);
    if (end == std::string::npos) break;
    const auto key = text.substr(start + kBrackets, end - start - kBrackets);
    note(key);
    const auto found = texts_.find(key);
    const auto next = end + kBrackets;
    result += text.substr(from, start - from);
    result += found == texts_.end() ? text.substr(start, next - start) : found->second.in(language);
    from = next;
  }
  return result + text.substr(from);
}

void BlankFiller::fill(LocalizedText& text) {
  auto byLanguage = text.all();
  for (auto& [language, words] : byLanguage) words = filled(words, language);
  text = LocalizedText(std::move(byLanguage));
}

void BlankFiller::fill(Instrument& instrument) {
  for (const auto& place : textPlacesOf(instrument)) {
    for (auto* text : place.texts) fill(*text);
  }
}

}  // namespace questionnaires
