// The items of a step, and how answers are stored.
#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "study/session/verification.h"
#include "study/storage/answer_repository.h"
#include "study/storage/records.h"
#include "tests/study/everything_instrument.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace study {
namespace session_answers_test {

using questionnaires::Response;
using storage::StorageError;

class SessionAnswersTest : public testing::Test {
 protected:
  void SetUp() override { tests::walkTo(session_, StepKind::Form); }

  void give(const std::string& item, const Response& response) {
    session_.record(
        {.item = item,
         .response = response,
         .itemOrder = 1,
         .firstTouch = 1.25,
         .responseTime = 2.5,
         .changes = 3,
         .language = "en"});
  }

  std::optional<GivenAnswer> kept(const std::string& item) {
    return storage::AnswerRepository(study_->database()).find(session_.visit(), item);
  }

  tests::MadeStudy study_{tests::protocolFrom(
      tests::protocolWithEverything(), {{"everything.json", tests::everythingInstrument()}})};
  Session session_ = Session::enrol(*study_, {.cohort = "surgeons"});
};

TEST_F(SessionAnswersTest, StoresEveryTypeOfAnswerUnchanged) {
  const std::vector<std::pair<std::string, Response>> given{
      {"agree", std::int64_t{5}},
      {"words", std::int64_t{3}},
      {"slide", 37.0},
      {"one", std::string("y")},
      {"many", std::vector<std::string>{"y", "x"}},
      {"count", 12.3},
      {"line", std::string("one line")},
      {"story", std::string("several\nlines")},
      {"pair", std::string("x")}};
  for (const auto& [item, response] : given) give(item, response);
  for (const auto& [item, response] : given) {
    ASSERT_TRUE(kept(item)) << item;
    EXPECT_EQ(kept(item)->response, response) << item;
    EXPECT_EQ(kept(item)->firstTouch, 1.25);
    EXPECT_EQ(kept(item)->responseTime, 2.5);
    EXPECT_EQ(kept(item)->changes, 3);
  }
}

TEST_F(SessionAnswersTest, StoresAnIntegerAsANumberIfTheItemAsksForANumber) {
  give("count", std::int64_t{12});
  give("slide", std::int64_t{50});
  EXPECT_EQ(kept("count")->response, Response(12.0));
  EXPECT_EQ(kept("slide")->response, Response(50.0));
}

TEST_F(SessionAnswersTest, ChangesAnAnswerInPlace) {
  give("agree", std::int64_t{2});
  give("agree", std::int64_t{4});
  EXPECT_EQ(session_.answers().size(), 1U);
  EXPECT_EQ(kept("agree")->response, Response(std::int64_t{4}));
  const auto events = study_->events().read(session_.id());
  const auto said = [](std::int64_t point) {
    return base::NamedArguments{{"item", std::string("agree")}, {"point", point}};
  };
  EXPECT_EQ(events.back().values, said(4));
  // the first answer stays in the audit trail
  EXPECT_EQ(events[events.size() - 2].values, said(2));
}

TEST_F(SessionAnswersTest, TakesAnAnswerThatIsGivenFasterAfterACrash) {
  for (const double seconds : {9.0, 0.0, 0.25, 8.999, 9.0, 30.0}) {
    session_.record(
        {.item = "agree",
         .response = std::int64_t{2},
         .itemOrder = 1,
         .firstTouch = seconds,
         .responseTime = seconds,
         .language = "en"});
    EXPECT_EQ(kept("agree")->firstTouch, 9.0);
    EXPECT_EQ(kept("agree")->responseTime, std::max(seconds, 9.0));
  }
  EXPECT_TRUE(verify(*study_).isSound());
}

TEST_F(SessionAnswersTest, StoresChangesTimeAndLanguageOfACorrectedAnswer) {
  session_.record(
      {.item = "agree",
       .response = std::int64_t{2},
       .itemOrder = 4,
       .firstTouch = 1.25,
       .responseTime = 2.5,
       .changes = 0,
       .language = "en"});
  session_.record(
      {.item = "agree",
       .response = std::int64_t{5},
       .itemOrder = 4,
       .firstTouch = 1.25,
       .responseTime = 7.75,
       .changes = 3,
       .language = "de"});
  const GivenAnswer corrected{
      .item = "agree",
      .response = std::int64_t{5},
      .itemOrder = 4,
      .firstTouch = 1.25,
      .responseTime = 7.75,
      .changes = 3,
      .language = "de"};
  EXPECT_EQ(kept("agree"), corrected);
  EXPECT_EQ(session_.answers(), std::vector<GivenAnswer>{corrected});
  bool isExported = false;
  for (const auto& row : storage::Records(study_->database()).answers()) {
    isExported = isExported || row.answer == corrected;
  }
  EXPECT_TRUE(isExported);
}

TEST_F(SessionAnswersTest, RefusesInvalidResponses) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<std::pair<std::string, Response>> wrong{
      {"elsewhere", std::int64_t{1}},
      {"1.1", std::int64_t{1}},
      {"agree", std::int64_t{0}},
      {"agree", std::int64_t{6}},
      {"agree", 3.0},
      {"agree", std::string("3")},
      {"slide", nan},
      {"slide", infinity},
      {"slide", 100.5},
      {"slide", -1.0},
      {"one", std::string("z")},
      {"one", std::int64_t{1}},
      {"many", std::vector<std::string>{"x", "x"}},
      {"many", std::vector<std::string>{"z"}},
      {"count", 70.1},
      {"count", 0.05},
      {"line", std::string("two\nlines")},
      {"line", std::string(501, 'x')},
      {"story", std::string("nul\0inside", 10)},
      {"story", std::string("\xff\xfe")},
      {"story", std::string("\xed\xa0\x80")},
      {"story", std::string(100'001, 'x')},
      {"pair", std::string("")}};
  for (const auto& [item, response] : wrong) {
    EXPECT_THROW(give(item, response), UserError) << item;
    EXPECT_FALSE(kept(item)) << item;
  }
  EXPECT_TRUE(session_.answers().empty());
}

TEST_F(SessionAnswersTest, RefusesImpossibleTimes) {
  auto answer = tests::answerTo(session_, session_.items().front());
  answer.firstTouch = 3.0;
  answer.responseTime = 2.0;  // earlier than the first touch
  EXPECT_THROW(session_.record(answer), StorageError);
  answer.firstTouch = -1.0;
  EXPECT_THROW(session_.record(answer), StorageError);
  answer.firstTouch = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(session_.record(answer), StorageError);
  EXPECT_TRUE(session_.answers().empty());
  EXPECT_EQ(tests::eventsOf(*study_, session_.id()).find("answered finished"), std::string::npos);
}

TEST_F(SessionAnswersTest, ShowsNobodyTheWordsOfAConstraint) {
  auto answer = tests::answerTo(session_, session_.items().front());
  answer.firstTouch = 3.0;
  answer.responseTime = 2.0;
  try {
    session_.record(answer);
    FAIL() << "an impossible time was stored";
  } catch (const StorageError& error) {
    const std::string words = error.what();
    EXPECT_EQ(words.find("CHECK"), std::string::npos) << words;
    EXPECT_EQ(words.find("response_s"), std::string::npos) << words;
    EXPECT_NE(words.find("please report it"), std::string::npos) << words;
  }
}

TEST_F(SessionAnswersTest, RetractsAnAnswerSoThatItIsMissingAgain) {
  give("agree", std::int64_t{2});
  give("name", std::string("Somebody"));
  EXPECT_TRUE(session_.missing().empty());
  session_.retract("agree");
  EXPECT_EQ(session_.missing(), std::vector<std::string>{"agree"});
  EXPECT_THROW(session_.finishStep(), UserError);
  session_.retract("name");
  EXPECT_EQ(session_.missing(), (std::vector<std::string>{"agree", "name"}));
}

TEST_F(SessionAnswersTest, RefusesToRetractAnItemThatIsNotAsked) {
  const std::string before = tests::eventsOf(*study_, session_.id());
  EXPECT_THROW(session_.retract("elsewhere"), UserError);
  EXPECT_EQ(tests::eventsOf(*study_, session_.id()), before);
}

TEST_F(SessionAnswersTest, CountsABlankTextAsMissing) {
  give("agree", std::int64_t{2});
  give("name", std::string(""));
  EXPECT_EQ(session_.missing(), std::vector<std::string>{"name"});
}

TEST_F(SessionAnswersTest, KeepsAnswersWhenTheLanguageIsSwitched) {
  give("agree", std::int64_t{2});
  session_.setLanguage("de");
  EXPECT_EQ(session_.language(), "de");
  EXPECT_EQ(kept("agree")->response, Response(std::int64_t{2}));
  EXPECT_EQ(kept("agree")->language, "en");  // the language in which it was read
  EXPECT_THROW(session_.setLanguage("fr"), UserError);
  EXPECT_EQ(session_.language(), "de");
}

TEST_F(SessionAnswersTest, OffersTheAlternativesOfTheBlock) {
  give("agree", std::int64_t{2});
  give("name", std::string("Somebody"));
  tests::walkTo(session_, StepKind::Preference);
  EXPECT_EQ(session_.step().alternatives, (std::vector<std::string>{"1", "2", "3"}));
  EXPECT_THROW(give("preferred", std::string("4")), UserError);
  EXPECT_THROW(give("preferred", std::string("interpolation")), UserError);
  give("preferred", std::string("3"));
}

}  // namespace session_answers_test
}  // namespace study
