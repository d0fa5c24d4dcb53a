// Whether an export says truly that it names no one.
#include "study/export/named_people.h"

#include <gtest/gtest.h>

#include "study/model/words_of_names.h"
#include "tests/study/everything_instrument.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"
#include "tests/support/says.h"

namespace study {
namespace named_people_test {

using tests::says;

class NamedPeopleTest : public testing::Test {
 protected:
  /// A live participant who signs with @p name and tells @p story.
  void take(const std::string& name, const std::string& story, double count = 3.0) {
    auto session = Session::enrol(*study_, {.cohort = "surgeons"});
    tests::walkTo(session, StepKind::Form);
    session.record({.item = "agree", .response = std::int64_t{1}, .itemOrder = 1});
    session.record({.item = "count", .response = count, .itemOrder = 2});
    if (!story.empty()) session.record({.item = "story", .response = story, .itemOrder = 4});
    session.record({.item = "name", .response = name, .itemOrder = 5});
    session.finishStep();
    tests::walkToTheEnd(session);
  }
  std::string readme(const std::string& name, bool isExact = false) {
    exportStudy(
        *study_, folder_ / name, {.runMode = RunMode::Live, .isExact = isExact, .hasTexts = true});
    return tests::contentOf(folder_ / name + "/README.md");
  }
  tests::ScratchFolder folder_;
  tests::MadeStudy study_{tests::protocolFrom(
      tests::protocolWithEverything(), {{"everything.json", tests::everythingInstrument()}})};
};

TEST_F(NamedPeopleTest, AreFoundInWhatOthersWrote) {
  take("Kari Åsgård", "it felt soft");
  EXPECT_TRUE(says(readme("without"), "No name that the study keeps apart is in this folder"));
  take("Ola Nordmann", "As KARI said, and ÅSGÅRD too: soft.");
  const auto text = readme("with");
  EXPECT_TRUE(says(text, "THIS FOLDER NAMES PEOPLE: 1 cell has"));
  EXPECT_TRUE(says(text, "(texts: 1)"));
  EXPECT_FALSE(says(text, "Åsgård") || says(text, "Nordmann")) << "it does not repeat them";
}

TEST_F(NamedPeopleTest, AreNotFoundInPartsOfOtherWords) {
  take("Ann Ek", "Annoying: a bare ekko");
  EXPECT_TRUE(says(readme("out"), "No name that the study keeps apart is in this folder"));
}

TEST_F(NamedPeopleTest, CannotBeSearchedForWhereNoNameIsKept) {
  take("X", "Kari was here");
  const auto text = readme("out");
  EXPECT_TRUE(says(text, "keeps no names"));
  EXPECT_FALSE(says(text, "Nothing in this folder names a person")) << text;
}

TEST_F(NamedPeopleTest, WhoAreAloneWithTheirBackgroundAreCounted) {
  for (int i = 0; i < 4; ++i) take("Xy", "", 3.0);
  EXPECT_TRUE(says(readme("alike"), "0 of 4 people who completed are alone"));
  take("Xy", "", 4.0);
  EXPECT_TRUE(says(readme("of one band"), "0 of 5 people who completed are alone"));
  EXPECT_TRUE(says(readme("exact", true), "1 of 5 people who completed are alone"));
  take("Xy", "", 27.0);
  EXPECT_TRUE(says(readme("alone"), "1 of 6 people who completed are alone"));
}

TEST_F(NamedPeopleTest, AreFoundInParticipantCodes) {
  auto session = Session::enrol(*study_, {.cohort = "surgeons", .code = "KARI-1"});
  tests::walkToTheEnd(session);
  EXPECT_FALSE(says(readme("without"), "NAMES PEOPLE"));
  take("Kari Åsgård", "");
  EXPECT_TRUE(says(readme("with"), "THIS FOLDER NAMES PEOPLE"));
}

using Words = std::vector<std::string>;

TEST(WordsOfNames, HaveNoCaseAndNoMarks) {
  EXPECT_EQ(
      wordsIn("Dr. Kari ÅSGÅRD-Lie, kari åsgård"),
      (Words{"dr", "kari", "asgard", "lie", "kari", "asgard"}));
  EXPECT_EQ(wordsIn("ŁUKASZ Čapek, łukasz čapek"), (Words{"lukasz", "capek", "lukasz", "capek"}));
  EXPECT_EQ(wordsIn("A\u030Asgard 3×4"), (Words{"asgard"})) << "an accent by itself";
  EXPECT_EQ(wordsIn("Ирина"), (Words{"Ирина"}));
  EXPECT_TRUE(wordsIn("").empty());
  EXPECT_TRUE(wordsIn("\xc3").empty()) << "half a letter";
}

TEST(WordsOfNames, MayBeWrittenWithoutMarks) {
  EXPECT_EQ(wordsIn("Huebner Hübner Hubner"), (Words{"hubner", "hubner", "hubner"}));
  EXPECT_EQ(
      wordsIn("Oestby Østby, Haagensen Hågensen"),
      (Words{"ostby", "ostby", "hagensen", "hagensen"}));
  EXPECT_EQ(
      wordsIn("Strauß Strauss, Bjærke Bjaerke"), (Words{"strauss", "strauss", "bjarke", "bjarke"}));
}

TEST(WordsOfNames, AreFoundAsTheyAreWritten) {
  EXPECT_EQ(wordNaming("asked for by Huebner", "Hübner"), "Huebner");
  EXPECT_EQ(wordNaming("asked for by Mueller.", "Anna Müller"), "Mueller");
  EXPECT_EQ(wordNaming("Hübners letter", "Jo Hübner"), "Hübners");
  EXPECT_EQ(wordNaming("ØSTBYS brev", "Østby"), "ØSTBYS");
  EXPECT_EQ(wordNaming("Oestby", "Østby"), "Oestby");
  EXPECT_EQ(wordNaming("a call by Bo", "Bo Ek"), "Bo");
  EXPECT_EQ(wordNaming("annoyed, and board", "Ann Boa"), "") << "other words, of short names";
  EXPECT_EQ(wordNaming("asked for it", "Anna Müller"), "");
}

TEST(WordsOfNames, AreOfThreeLettersOrOfTwoWithACapital) {
  EXPECT_EQ(wordsIn("Bo and Øy Li: bo in an øy, J. K."), (Words{"bo", "and", "oy", "li"}));
  EXPECT_EQ(wordsIn("Žo Źa ŽO, ža Ĺa ĺa"), (Words{"zo", "za", "zo", "la"}));
}

}  // namespace named_people_test
}  // namespace study
