#include "study/words/words.h"

#include <gtest/gtest.h>

#include "study/report/html_report.h"
#include "tests/study/report/section.h"

namespace study::words {
namespace {

/// The places in a sentence where something is put in: "{}", "{:.2f}".
std::multiset<std::string> placesIn(const std::string& text) {
  std::multiset<std::string> places;
  for (auto at = text.find('{'); at != std::string::npos; at = text.find('{', at + 1)) {
    places.insert(text.substr(at, text.find('}', at) + 1 - at));
  }
  return places;
}

class WordsTest : public testing::TestWithParam<std::string> {};

TEST_P(WordsTest, SayEverySentenceOfAReport) {
  std::vector<report::ReportSection> sections{tests::madeUpSection()};
  auto& section = sections.front();
  section.words = wordsIn(GetParam());
  std::set<std::string_view> flags;
  for (const auto& cohort : section.results.families.front().cohorts) {
    for (const auto& flag : cohort.flags) flags.insert(flag.id);
  }
  EXPECT_EQ(flags.size(), 13U);  // every kind there is
  for (const bool isDeclared : {true, false}) {
    section.results.families.front().isDeclared = isDeclared;
    for (const auto test : {protocols::TestType::Welch, protocols::TestType::PairedT}) {
      section.results.families.front().family.test = test;
      report::asHtml(sections);
    }
  }
  section.results.runMode = RunMode::Pilot;
  section.history.changes.clear();
  report::asHtml(sections);
  section.history.versionsSinceBegun = 0;
  report::asHtml(sections);
  std::string missing;
  for (const auto& sentence : section.words.missing()) missing += "  " + sentence + "\n";
  EXPECT_EQ(missing, "");
}

TEST_P(WordsTest, PutTheSameThingsIn) {
  const auto words = wordsIn(GetParam());
  for (const auto& [english, translated] : words.catalogue()) {
    EXPECT_EQ(placesIn(english), placesIn(translated)) << english;
    EXPECT_FALSE(translated.empty()) << english;
  }
}

INSTANTIATE_TEST_SUITE_P(Languages, WordsTest, testing::Values("de", "nb"));

TEST(Words, AreEnglishWhereNothingElseIsSaid) {
  EXPECT_EQ(wordsIn("en")("Participants"), "Participants");
  EXPECT_EQ(wordsIn("de")("no such sentence"), "no such sentence");
  EXPECT_EQ(languages(), (std::vector<std::string>{"en", "de", "nb"}));
  EXPECT_THROW(wordsIn("tlh"), std::invalid_argument);
}

}  // namespace
}  // namespace study::words
