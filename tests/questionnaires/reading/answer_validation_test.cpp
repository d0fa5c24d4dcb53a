#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "questionnaires/model/answer.h"

namespace questionnaires {
namespace answer_validation_test {

using Texts = std::vector<std::string>;

const Item kAgreement{.type = ItemType::Likert};
const Item kSlider{.type = ItemType::Slider, .step = 5.0};
const Item kNumber{.type = ItemType::Number, .least = 0.0, .most = 1.0, .step = 0.1};
const Item kChoice{.type = ItemType::SingleChoice, .options = {{.id = "yes"}, {.id = "no"}}};
const Item kChoices{.type = ItemType::MultipleChoice, .options = {{.id = "a"}, {.id = "b"}}};
const Item kPair{.type = ItemType::PairwiseChoice, .options = {{.id = "a"}, {.id = "b"}}};
const Item kAlternatives{
    .type = ItemType::SingleChoice, .optionSource = OptionSource::Alternatives};
const Item kShort{.type = ItemType::ShortText};
const Item kLong{.type = ItemType::LongText};

std::string reason(const Item& item, const Response& response, const Texts& alternatives = {}) {
  return validationError(item, response, alternatives).value_or("none");
}

std::string text(std::string_view character, std::size_t times) {
  std::string result;
  for (std::size_t i = 0; i < times; ++i) result += character;
  return result;
}

TEST(AnswerValidation, AcceptsThePointsOfAScale) {
  for (std::int64_t point = 1; point <= 5; ++point) EXPECT_EQ(reason(kAgreement, point), "none");
}

TEST(AnswerValidation, RefusesPointsOutsideTheScale) {
  EXPECT_EQ(reason(kAgreement, std::int64_t{0}), "0 is no point of the scale from 1 to 5");
  EXPECT_EQ(reason(kAgreement, std::int64_t{6}), "6 is no point of the scale from 1 to 5");
  EXPECT_NE(reason(kAgreement, std::numeric_limits<std::int64_t>::min()), "none");
}

TEST(AnswerValidation, RefusesHalfAPoint) {
  EXPECT_EQ(reason(kAgreement, 3.0), "the answer is no point of the scale");
  EXPECT_EQ(reason(kAgreement, "3"), "the answer is no point of the scale");
}

TEST(AnswerValidation, TreatsOppositeWordsLikeAScale) {
  const Item item{.type = ItemType::SemanticDifferential, .scale = {.lowest = -3, .points = 7}};
  EXPECT_EQ(reason(item, std::int64_t{-3}), "none");
  EXPECT_EQ(reason(item, std::int64_t{4}), "4 is no point of the scale from -3 to 3");
}

TEST(AnswerValidation, AcceptsTheStepsOfASlider) {
  EXPECT_EQ(reason(kSlider, 0.0), "none");
  EXPECT_EQ(reason(kSlider, 100.0), "none");
  EXPECT_EQ(reason(kSlider, std::int64_t{35}), "none");
}

TEST(AnswerValidation, IsRaisedBetweenTheStepsAndBeyondTheEnds) {
  EXPECT_EQ(reason(kSlider, 52.0), "52 is between the steps of 5 from 0");
  EXPECT_EQ(reason(kSlider, 105.0), "105 is not between 0 and 100");
  EXPECT_EQ(reason(kSlider, -5.0), "-5 is not between 0 and 100");
}

TEST(AnswerValidation, KnowsThatDecimalStepsAreNoBinaryNumbers) {
  for (int i = 0; i <= 10; ++i) EXPECT_EQ(reason(kNumber, 0.1 * i), "none") << i;
  EXPECT_NE(reason(kNumber, 0.15), "none");
}

TEST(AnswerValidation, LetsEveryValuePassWithoutSteps) {
  const Item item{.type = ItemType::Slider, .step = 0.0};
  EXPECT_EQ(reason(item, 33.333), "none");
}

TEST(AnswerValidation, RefusesNumbersThatAreNotFinite) {
  for (const double number : {NAN, -NAN, INFINITY, -INFINITY}) {
    EXPECT_EQ(reason(kNumber, number), "the answer is no finite number");
    EXPECT_EQ(reason(kSlider, number), "the answer is no finite number");
  }
  EXPECT_EQ(reason(kNumber, "1"), "the answer is no number");
}

TEST(AnswerValidation, AcceptsAnOption) {
  EXPECT_EQ(reason(kChoice, "yes"), "none");
  EXPECT_EQ(reason(kPair, "b"), "none");
}

TEST(AnswerValidation, RefusesWhatIsNoOption) {
  EXPECT_EQ(reason(kChoice, "maybe"), "there is no option 'maybe' to choose");
  EXPECT_EQ(reason(kChoice, ""), "there is no option '' to choose");
  EXPECT_EQ(reason(kPair, std::int64_t{1}), "the answer is not one of the options");
  EXPECT_EQ(reason(kChoice, Texts{"yes"}), "the answer is not one of the options");
}

TEST(AnswerValidation, KnowsOnlyTheAlternativesOfTheBlock) {
  EXPECT_EQ(reason(kAlternatives, "2", {"1", "2", "3"}), "none");
  EXPECT_EQ(reason(kAlternatives, "4", {"1", "2", "3"}), "there is no alternative '4' to choose");
  EXPECT_NE(reason(kAlternatives, "1"), "none");
}

TEST(AnswerValidation, AcceptsAnyNumberOfOptions) {
  EXPECT_EQ(reason(kChoices, Texts{}), "none");
  EXPECT_EQ(reason(kChoices, Texts{"b", "a"}), "none");
}

TEST(AnswerValidation, RefusesAnOptionChosenTwice) {
  EXPECT_EQ(reason(kChoices, Texts{"a", "a"}), "the option 'a' is chosen twice");
  EXPECT_EQ(reason(kChoices, Texts{"a", "c"}), "there is no option 'c' to choose");
  EXPECT_EQ(reason(kChoices, "a"), "the answer is no list of options");
}

TEST(AnswerValidation, AcceptsAHundredThousandCharactersOfAnyScript) {
  for (const auto* character : {"a", "é", "😀", "م", "\xCC\x81", "\xE2\x80\xAE", "\n"}) {
    EXPECT_EQ(reason(kLong, text(character, 100'000)), "none") << character;
  }
}

TEST(AnswerValidation, CountsCharactersAndNotBytes) {
  EXPECT_EQ(reason(kShort, text("😀", 500)), "none");
  EXPECT_EQ(reason(kShort, text("😀", 501)), "the text has 501 characters; at most 500 can be kept");
  EXPECT_EQ(
      reason(kLong, text("a", 100'001)),
      "the text has 100001 characters; at most 100000 can be kept");
  const Item two{.type = ItemType::LongText, .longestAnswer = 2};
  EXPECT_EQ(reason(two, "é😀"), "none");
  EXPECT_NE(reason(two, "abc"), "none");
}

TEST(AnswerValidation, RefusesWhatIsNoText) {
  EXPECT_EQ(reason(kLong, std::string("a\0b", 3)), "the text holds the character NUL");
  EXPECT_EQ(reason(kLong, "caf\xE9"), "the text is no sound UTF-8");
  EXPECT_EQ(reason(kLong, "\xED\xA0\x80"), "the text is no sound UTF-8");
  EXPECT_EQ(reason(kLong, 1.0), "the answer is no text");
}

TEST(AnswerValidation, KeepsAShortTextOnOneLine) {
  EXPECT_EQ(reason(kShort, "a\nb"), "the text has more than one line");
  EXPECT_EQ(reason(kLong, "a\r\nb\tc"), "none");
}

}  // namespace answer_validation_test
}  // namespace questionnaires
