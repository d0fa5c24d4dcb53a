// Every text is read back byte for byte.
#include <gtest/gtest.h>

#include "study/session/verification.h"
#include "tests/study/everything_instrument.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace study {
namespace texts_test {

class TextsTest : public testing::Test {
 protected:
  void SetUp() override { tests::walkTo(session_, StepKind::Form); }

  tests::MadeStudy study_{tests::protocolFrom(
      tests::protocolWithEverything(), {{"everything.json", tests::everythingInstrument()}})};
  Session session_ = Session::enrol(*study_, {.cohort = "surgeons"});
};

struct OddText {
  const char* name;
  std::string text;
};

class OddTextsTest : public TextsTest, public testing::WithParamInterface<OddText> {};

TEST_P(OddTextsTest, AreReadBackByteForByteAfterARestart) {
  const auto id = session_.id();
  session_.record({.item = "story", .response = GetParam().text, .itemOrder = 1, .language = "en"});
  { const Session gone = std::move(session_); }
  study_.reopen();
  const auto resumed = Session::resume(*study_, id);
  ASSERT_EQ(resumed.answers().size(), 1U);
  EXPECT_EQ(std::get<std::string>(resumed.answers().front().response), GetParam().text);
  EXPECT_TRUE(verify(*study_).isSound());
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

INSTANTIATE_TEST_SUITE_P(
    Texts,
    OddTextsTest,
    testing::Values(
        OddText{"TheLongest", std::string(100'000, 'x')},
        OddText{"TheLongestInBytes", repeated("\xF0\x9F\xA6\xB4", 100'000)},
        OddText{"Emoji", "\xF0\x9F\x91\xA9\xF0\x9F\x8F\xBD\xE2\x80\x8D\xE2\x9A\x95\xEF\xB8\x8F"},
        OddText{"RightToLeft", "\xD7\xA9\xD7\x9C\xD7\x95\xD7\x9D \xD8\xB3\xD9\x84\xD8\xA7"},
        OddText{"TurnedAround", "\xE2\x80\xAE backwards"},
        OddText{"Combining", "e\xCC\x81\xCC\xA3 \xE0\xB8\x81\xE0\xB8\xB3"},
        OddText{"Sql", "'; DROP TABLE answer; --"},
        OddText{"Quotes", "\"quotes\", 'more', \\ backslash, `ticks`, %s %n {}"},
        OddText{"Formula", "=HYPERLINK(\"http://x\")"},
        OddText{"Spaces", " at both ends "},
        OddText{"Lines", "tab\there\r\nand\nlines\n"},
        OddText{"ByteOrderMark", "\xEF\xBB\xBF and words"},
        OddText{"Controls", "\x01\x02\x1b[31m"},
        OddText{"WordsOfTheAuditTrail", "(kept apart)"},
        OddText{"WordsLikeAHash", "sha256:0000"}),
    [](const auto& odd) { return odd.param.name; });

TEST_F(TextsTest, AreDistinguishedIfTheyLookAlike) {
  const std::string composed = "\xC3\xA9";     // é in one code point
  const std::string decomposed = "e\xCC\x81";  // and in two
  session_.record({.item = "story", .response = composed, .itemOrder = 1, .language = "en"});
  session_.record({.item = "line", .response = decomposed, .itemOrder = 2, .language = "en"});
  EXPECT_EQ(std::get<std::string>(session_.answers()[0].response), composed);
  EXPECT_EQ(std::get<std::string>(session_.answers()[1].response), decomposed);
}

TEST_F(TextsTest, AreRefusedAsNotesIfTheyAreInvalid) {
  const std::string before = tests::eventsOf(*study_, session_.id());
  EXPECT_THROW(session_.note("\xff"), storage::StorageError);
  EXPECT_THROW(session_.note(std::string("a\0b", 3)), storage::StorageError);
  EXPECT_THROW(session_.pause("\xc3"), storage::StorageError);
  EXPECT_EQ(session_.state(), SessionState::Consented);
  EXPECT_THROW(study_->note(EventKind::UnblindedExport, "\xff"), storage::StorageError);
  EXPECT_EQ(tests::eventsOf(*study_, session_.id()), before);
  session_.pause("caf\xC3\xA9");
}

TEST_F(TextsTest, AreLimitedToAMillionCharactersByTheTable) {
  const auto keep = [&](const std::string& length) {
    study_->database().execute(
        "INSERT OR REPLACE INTO answer VALUES (1, 1, 1, 'story', 1, 'text', NULL, NULL, "
        "printf('%.*c', " +
        length + ", 'x'), 0, 0, 0, 'en', '', NULL)");
  };
  keep("1000000");
  EXPECT_THROW(keep("1000001"), storage::StorageError);
}

}  // namespace texts_test
}  // namespace study
