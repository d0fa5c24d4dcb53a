// Instruments that were made by a program and not read from a file.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "questionnaires/model/instrument.h"

namespace questionnaires {
namespace problems_of_test {

LocalizedText english(const std::string& words) {
  return LocalizedText({{"en", words}});
}

Instrument sound() {
  return {
      .id = "small",
      .version = "1",
      .title = english("A title"),
      .languages = {"en"},
      .items = {
          {.id = "a",
           .text = english("It felt real."),
           .scale = {.lowLabel = english("no"), .highLabel = english("yes")}}}};
}

/// The first problem, as a person reads it.
std::string said(const Instrument& instrument) {
  const auto problems = problemsOf(instrument);
  return problems.all().empty() ? "nothing" : describe({problems.all().front()});
}

TEST(ProblemsOf, AValidInstrumentAreEmpty) {
  EXPECT_EQ(said(sound()), "nothing");
}

TEST(ProblemsOf, AnInstrumentNameItsBadIds) {
  auto instrument = sound();
  instrument.id = "a b";
  EXPECT_EQ(said(instrument), "error   $.id: 'a b' cannot be an id; give it a name\n");
  instrument = sound();
  instrument.items[0].id = "";
  EXPECT_EQ(said(instrument), "error   $.items[0].id: '' cannot be an id; give it a name\n");
  instrument = sound();
  instrument.scores = {{.id = "", .title = english("S"), .items = {"a"}}};
  EXPECT_EQ(said(instrument), "error   $.scores[0].id: '' cannot be an id; give it a name\n");
}

TEST(ProblemsOf, AnInstrumentNameAKeyThatIsNone) {
  auto instrument = sound();
  instrument.items[0].key = 0;
  EXPECT_EQ(
      said(instrument),
      "error   $.items[0].key: the key is 0; write 1 where a high answer is good, -1 where a low "
      "one is\n");
}

TEST(ProblemsOf, AnInstrumentNameAScaleThatIsNone) {
  auto instrument = sound();
  instrument.items[0].scale.points = 1;
  EXPECT_EQ(
      said(instrument),
      "error   $.items[0].scale.points: a scale of 1 points; choose from 2 to 101\n");
}

TEST(ProblemsOf, AnInstrumentNameNumbersThatAreNone) {
  auto instrument = sound();
  instrument.items[0] = {
      .id = "n", .type = ItemType::Number, .text = english("N"), .least = NAN, .most = 1.0};
  EXPECT_NE(said(instrument).find("$.items[0].least: least is nan"), std::string::npos);
  instrument.items[0].least = 0.0;
  instrument.items[0].step = NAN;
  EXPECT_NE(said(instrument).find("$.items[0].step: the step is negative"), std::string::npos);
  instrument = sound();
  instrument.scores = {{.id = "s", .title = english("S"), .items = {"a"}, .offset = INFINITY}};
  EXPECT_NE(said(instrument).find("$.scores[0].offset"), std::string::npos);
}

TEST(ProblemsOf, AnInstrumentNameAnswersThatAreTooLong) {
  auto instrument = sound();
  instrument.items[0] = {
      .id = "w", .type = ItemType::LongText, .text = english("W"), .longestAnswer = 1'000'000};
  EXPECT_EQ(
      said(instrument),
      "error   $.items[0].longest_answer: 1000000 characters cannot be kept; write a number from 1 "
      "to 100000\n");
}

TEST(ProblemsOf, AnInstrumentWarnOfStatementsThatCompare) {
  auto instrument = sound();
  instrument.items[0].comparedWith = Reference::Previous;
  EXPECT_EQ(
      said(instrument),
      "warning $.items[0].relative_to: this compares with what was felt just before; an order must "
      "give it a predecessor: whatever is felt first has none\n");
  EXPECT_FALSE(problemsOf(instrument).hasErrors());
}

TEST(ProblemsOf, AnInstrumentWarnOfWhatIsStillToBeFilledIn) {
  auto instrument = sound();
  instrument.introduction = english("Write to [[name]] at [[place]]. [Not this.] [[nor this");
  EXPECT_EQ(
      said(instrument),
      "warning $.introduction.en: still to be filled in: [[name]], [[place]]; write it into "
      "'texts' of the protocol, or into this file\n");
}

TEST(ProblemsOf, AnInstrumentWarnOfLanguagesThatAreNotDeclared) {
  auto instrument = sound();
  instrument.title = LocalizedText({{"en", "A"}, {"fr", "B"}});
  EXPECT_NE(said(instrument).find("warning $.title.fr: a text in 'fr'"), std::string::npos);
}

TEST(ProblemsOf, AnInstrumentWarnOfScoresOverDifferentRanges) {
  auto instrument = sound();
  instrument.items.push_back({.id = "n", .type = ItemType::Number, .text = english("N")});
  instrument.scores = {{.id = "s", .title = english("S"), .items = {"a", "n"}}};
  EXPECT_NE(said(instrument).find("warning $.scores[0].items: these items"), std::string::npos);
}

TEST(ProblemsOf, ASharedScaleAreReportedOnce) {
  auto instrument = sound();
  instrument.scale = Scale{.points = 3, .pointLabels = {english("a"), english("b")}};
  instrument.items[0].scale = *instrument.scale;
  instrument.items.push_back(instrument.items[0]);
  instrument.items[1].id = "b";
  instrument.items[1].text = english("b");
  const auto problems = problemsOf(instrument);
  ASSERT_EQ(problems.all().size(), 1U);
  EXPECT_EQ(problems.all()[0].path, "$.scale.point_labels");
}

TEST(ProblemsOf, ItemsThatReadTheSameAreWarnings) {
  auto instrument = sound();
  instrument.items.push_back(instrument.items[0]);
  instrument.items[1].id = "b";
  EXPECT_NE(
      said(instrument).find("warning $.items[1].text: 'a' has the same text"), std::string::npos)
      << said(instrument);
}

TEST(ProblemsOf, AScaleWithTheSameWordsAtBothEndsIsAWarning) {
  auto instrument = sound();
  instrument.items[0].scale = {.lowLabel = english("no"), .highLabel = english("no")};
  EXPECT_NE(said(instrument).find("warning $.items[0]: both ends"), std::string::npos)
      << said(instrument);
}

TEST(ProblemsOf, ManyTextsInALanguageThatIsNotListedAreOneWarning) {
  auto instrument = sound();
  const LocalizedText both({{"en", "x"}, {"fr", "y"}});
  instrument.title = both;
  instrument.introduction = both;
  const auto words = said(instrument);
  EXPECT_NE(words.find("warning $.languages: 2 texts are in 'fr', which"), std::string::npos)
      << words;
  EXPECT_EQ(words.find("$.title"), std::string::npos) << words;
}

}  // namespace problems_of_test
}  // namespace questionnaires
