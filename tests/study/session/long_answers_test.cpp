// Every free-text answer is stored byte for byte.
#include <random>

#include <gtest/gtest.h>

#include "questionnaires/json/document.h"
#include "study/session/verification.h"
#include "study/storage/records.h"
#include "tests/study/everything_instrument.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace study {
namespace long_answers_test {

constexpr std::size_t kMost = 100'000;  // characters in a long text

std::string encoded(char32_t c) {
  const auto byte = [](char32_t bits) { return static_cast<char>(bits); };
  if (c < 0x80) return {byte(c)};
  if (c < 0x800) return {byte(0xC0 | c >> 6), byte(0x80 | (c & 0x3F))};
  if (c < 0x10000) {
    return {byte(0xE0 | c >> 12), byte(0x80 | (c >> 6 & 0x3F)), byte(0x80 | (c & 0x3F))};
  }
  return {
      byte(0xF0 | c >> 18),
      byte(0x80 | (c >> 12 & 0x3F)),
      byte(0x80 | (c >> 6 & 0x3F)),
      byte(0x80 | (c & 0x3F))};
}

/// @p count characters of all Unicode planes: letters, unassigned code points, the last one.
std::string anyCharacters(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::string text;
  for (std::size_t i = 0; i < count;) {
    const auto c = static_cast<char32_t>(1 + random() % 0x10FFFF);
    if (c >= 0xD800 && c <= 0xDFFF) continue;  // a single surrogate is not a character
    text += encoded(c);
    ++i;
  }
  return text;
}

struct Text {
  const char* name;
  std::string words;
};

void PrintTo(const Text& text, std::ostream* out) {
  *out << text.words.size() << " bytes";
}

std::vector<Text> texts() {
  return {
      {"Emoji", "\xF0\x9F\x91\xA9\xF0\x9F\x8F\xBD\xE2\x80\x8D\xE2\x9A\x95\xEF\xB8\x8F cut"},
      {"RightToLeft", "\xD7\xA9\xD7\x9C\xD7\x95\xD7\x9D \xE2\x80\xAE \xD9\x85\xD8\xB1"},
      {"Composed", "\xC3\xA5"},     // å as one code point
      {"Decomposed", "a\xCC\x8A"},  // å as two: other bytes, which must not be normalised
      {"ByteOrderMark", "\xEF\xBB\xBFx"},
      {"LastCharacter", "\xF4\x8F\xBF\xBF"},
      {"ControlCharacters", "\x01\x02\x1B[31m\x7F\t\r\n \n"},
      {"Sql", "'); DROP TABLE answer; --"},
      {"Formula", "=HYPERLINK(\"x\")"},
      {"Letters", std::string(kMost, 'x')},
      {"FourBytesEach", anyCharacters(kMost, 1)},
      {"Newlines", std::string(kMost, '\n')},
  };
}

class LongAnswersTest : public testing::TestWithParam<Text> {
 protected:
  void SetUp() override { tests::walkTo(*session_, StepKind::Form); }

  void write(const std::string& words) {
    auto answer = tests::answerTo(*session_, session_->items().front());
    answer.item = "story";
    answer.response = words;
    session_->record(answer);
  }

  std::string kept() {
    for (const auto& record : storage::Records(study_->database()).answers()) {
      if (record.answer.item == "story") return std::get<std::string>(record.answer.response);
    }
    return "nothing";
  }

  tests::MadeStudy study_{tests::protocolFrom(
      tests::protocolWithEverything(), {{"everything.json", tests::everythingInstrument()}})};
  std::optional<Session> session_{Session::enrol(*study_, {.cohort = "surgeons"})};
};

TEST_P(LongAnswersTest, AreStoredByteForByte) {
  const auto& words = GetParam().words;
  write(words);
  session_.reset();
  study_.reopen();
  EXPECT_TRUE(kept() == words);
  EXPECT_TRUE(verify(*study_).isSound());
}

TEST_P(LongAnswersTest, AreRefusedWithOneCharacterTooMany) {
  const auto& words = GetParam().words;
  const auto missing = kMost - *questionnaires::utf8CharacterCount(words);
  EXPECT_THROW(write(words + std::string(missing + 1, 'x')), UserError);
  EXPECT_EQ(kept(), "nothing");
  write(words + std::string(missing, 'x'));
  EXPECT_TRUE(kept() == words + std::string(missing, 'x'));
}

INSTANTIATE_TEST_SUITE_P(Of, LongAnswersTest, testing::ValuesIn(texts()), [](const auto& text) {
  return text.param.name;
});

}  // namespace long_answers_test
}  // namespace study
