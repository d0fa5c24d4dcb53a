// What participants may read, word by word.
#include <cctype>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "questionnaires/reading/instrument_file.h"
#include "tests/questionnaires/shipped_instruments.h"

namespace questionnaires {
namespace library_words_test {

using tests::isInstrument;
using tests::shipped;
using tests::visibleTexts;

/// The words of a text in small letters: whatever stands between spaces and punctuation.
std::set<std::string> wordsOf(std::string_view text) {
  std::set<std::string> words;
  std::string word;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || byte >= 0x80) {
      word += static_cast<char>(byte < 0x80 ? std::tolower(byte) : byte);
    } else {
      words.insert(std::exchange(word, {}));
    }
  }
  words.insert(word);
  return words;
}

/// JSON with a space where it ends a line within a text: "\\n" is no letter.
std::string withoutLineBreaks(std::string json) {
  for (auto at = json.find("\\n"); at != std::string::npos; at = json.find("\\n", at)) {
    json.replace(at, 2, " ");
  }
  return json;
}

TEST(Library, IsPoliteInGerman) {
  for (const auto& [id, instrument] : shipped()) {
    for (const auto& text : visibleTexts(instrument)) {
      const auto words = wordsOf(text.in("de"));
      for (const auto* familiar :
           {"du", "dich", "dir", "dein", "deine", "deiner", "deinem", "deinen"}) {
        EXPECT_EQ(words.count(familiar), 0U) << id << ": " << text.in("de");
      }
    }
  }
}

TEST(Library, NamesNoCondition) {
  const std::vector<std::string> beginnings{
      "interpol",
      "kalman",
      "finit",
      "element",
      "spline",
      "hermit",
      "cubic",
      "kubisch",
      "osteop",
      "sclerot",
      "sklerot",
      "cortic",
      "kortikal",
      "cancell",
      "spongiös"};
  const std::set<std::string> names{"fem", "fe", "kf", "pi", "dense", "porous", "lookup"};
  for (const auto& file : libraryFiles()) {
    if (!isInstrument(file.name)) continue;
    for (const auto& word : wordsOf(withoutLineBreaks(std::string(file.content)))) {
      EXPECT_EQ(names.count(word), 0U) << file.name << ": " << word;
      for (const auto& beginning : beginnings) {
        EXPECT_NE(word.rfind(beginning, 0), 0U) << file.name << ": " << word;
      }
    }
  }
}

}  // namespace library_words_test
}  // namespace questionnaires
