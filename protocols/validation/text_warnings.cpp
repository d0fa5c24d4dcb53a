// Warnings on words in texts that participants read: {words} that nothing fills in, and words that
// name a condition.
#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "protocols/model/messages.h"
#include "protocols/validation/validation.h"
#include "questionnaires/json/document.h"
#include "questionnaires/reading/instrument_problems.h"

namespace protocols {
namespace {

using questionnaires::LocalizedText;
using questionnaires::Problems;

/// The words in braces that are filled in in every text, and in addition in texts of phases.
constexpr std::array<std::string_view, 2> kKnownEverywhere{"{label}", "{Label}"};
constexpr std::array<std::string_view, 3> kKnownInPhases{"{label}", "{Label}", "{minimum_cuts}"};

/// Whether the character is part of a word. All bytes of letters outside of ASCII are.
bool isWordCharacter(char c) noexcept {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

bool containsWord(std::string_view text, std::string_view word) {
  for (auto at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const auto end = at + word.size();
    const bool isBegin = at == 0 || !isWordCharacter(text[at - 1]);
    if (isBegin && (end == text.size() || !isWordCharacter(text[end]))) return true;
  }
  return false;
}

/// Whether @p name cannot be everyday language: it has a digit, a blank or a sign, or two capitals
/// in a row.
bool isUnlikeEverydayWords(std::string_view name) {
  const auto isCapital = [](char c) { return c >= 'A' && c <= 'Z'; };
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    const bool isLetter =
        isCapital(c) || (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80;
    if (!isLetter || (i > 0 && isCapital(c) && isCapital(name[i - 1]))) return name.size() > 1;
  }
  return false;
}

/// The words in braces, without blanks in them: "{lable}".
std::vector<std::string> bracedWordsIn(const std::string& text) {
  constexpr std::size_t kLongest = 40;  // [bytes]
  std::vector<std::string> words;
  for (auto from = text.find('{'); from != std::string::npos; from = text.find('{', from + 1)) {
    const auto end = text.find_first_of("{} \t\r\n", from + 1);
    const bool isWord = end != std::string::npos && text[end] == '}' && end - from > 1;
    if (isWord && end - from <= kLongest) words.push_back(text.substr(from, end + 1 - from));
  }
  return words;
}

/// Checks texts, and warns of each word once at each place.
class TextWarningCheck {
 public:
  TextWarningCheck(const Protocol& protocol, Problems& problems)
      : protocol_(protocol), problems_(problems) {}

  void check(
      const std::string& path, const LocalizedText& text, std::span<const std::string_view> known) {
    for (const auto& [language, words] : text.all()) {
      for (const auto& word : bracedWordsIn(words)) checkBraced(path, word, known);
      checkNames(path, words);
    }
  }

 private:
  bool isFirst(const std::string& path, const std::string& word) {
    return said_.insert(path + ' ' + word).second;
  }

  void checkBraced(
      const std::string& path, const std::string& word, std::span<const std::string_view> known) {
    if (std::ranges::find(known, word) != known.end() || !isFirst(path, word)) return;
    const auto meant = questionnaires::nearest(word, known).value_or(known.front());
    problems_.warn(
        path,
        message("braces_not_known", word),
        message("braces_not_known.fix", std::string(meant)));
  }

  void checkNames(const std::string& path, const std::string& words) {
    if (protocol_.isOpenLabel) return;
    for (const auto& condition : protocol_.conditions) {
      for (const auto* name : {&condition.title, &condition.id}) {
        if (!isUnlikeEverydayWords(*name) || !containsWord(words, *name)) continue;
        if (isFirst(path, *name)) {
          problems_.warn(
              path,
              message("text_names_condition", *name, condition.id),
              message("text_names_condition.fix"));
        }
        break;
      }
    }
  }

  const Protocol& protocol_;
  Problems& problems_;
  std::set<std::string> said_;
};

}  // namespace

void addWordWarnings(const LoadedProtocol& loaded, Problems& problems) {
  const auto& protocol = loaded.protocol;
  TextWarningCheck texts(protocol, problems);
  for (std::size_t i = 0; i < protocol.phases.size(); ++i) {
    const std::string path = "$.phases[" + std::to_string(i) + "].text";
    texts.check(path, protocol.phases[i].text, kKnownInPhases);
  }
  std::set<std::string> seen;
  for (const auto& use : instrumentUses(protocol)) {
    if (use.phase == PhaseType::Interview || !seen.insert(use.instrument).second) continue;
    auto instrument = *loaded.instrument(use.instrument);
    for (const auto& place : questionnaires::textPlacesOf(instrument)) {
      std::string path = use.instrument + " $." + place.name;
      std::ranges::replace(path, '/', '.');
      for (const auto* text : place.texts) texts.check(path, *text, kKnownEverywhere);
    }
  }
}

}  // namespace protocols
