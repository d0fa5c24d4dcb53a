#include "questionnaires/model/answer.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace questionnaires {
namespace answer_test {

using Texts = std::vector<std::string>;

LocalizedText words(const std::string& english, const std::string& german) {
  return LocalizedText({{"en", english}, {"de", german}});
}

const Item kAgreement{
    .id = "agreement", .scale = {.lowLabel = words("no", "nein"), .highLabel = words("yes", "ja")}};
const Item kChoice{
    .id = "choice",
    .type = ItemType::SingleChoice,
    .options = {{"a", words("one", "eins")}, {"b", words("two", "zwei")}}};

TEST(LabelOf, NamesTheEndsOfAScale) {
  EXPECT_EQ(labelOf(kAgreement, std::int64_t{1}, "en"), "no");
  EXPECT_EQ(labelOf(kAgreement, std::int64_t{5}, "de"), "ja");
  EXPECT_EQ(labelOf(kAgreement, std::int64_t{3}, "de"), "");
}

TEST(LabelOf, NamesEveryPointThatHasALabel) {
  const Item item{
      .scale = {
          .lowest = 0,
          .points = 3,
          .pointLabels = {words("a", "A"), words("b", "B"), words("c", "C")}}};
  EXPECT_EQ(labelOf(item, std::int64_t{0}, "en"), "a");
  EXPECT_EQ(labelOf(item, std::int64_t{1}, "de"), "B");
  EXPECT_EQ(labelOf(item, std::int64_t{3}, "de"), "");
}

TEST(LabelOf, NamesOppositeWordsAndTheEndsOfASlider) {
  const Item pair{
      .type = ItemType::SemanticDifferential,
      .scale = {.points = 7},
      .leftText = words("cold", "kalt"),
      .rightText = words("warm", "warm")};
  EXPECT_EQ(labelOf(pair, std::int64_t{1}, "de"), "kalt");
  EXPECT_EQ(labelOf(pair, std::int64_t{7}, "en"), "warm");
  const Item slider{
      .type = ItemType::Slider,
      .leftText = words("low", "tief"),
      .rightText = words("high", "hoch")};
  EXPECT_EQ(labelOf(slider, 0.0, "en"), "low");
  EXPECT_EQ(labelOf(slider, 50.0, "en"), "");
  EXPECT_EQ(labelOf(slider, std::int64_t{100}, "de"), "hoch");
}

TEST(LabelOf, NamesOptions) {
  EXPECT_EQ(labelOf(kChoice, "b", "de"), "zwei");
  EXPECT_EQ(labelOf(kChoice, "b", "nb"), "two");
  EXPECT_EQ(labelOf(kChoice, "c", "de"), "");
  EXPECT_EQ(labelOf(kChoice, Texts{"b", "a"}, "en"), "two; one");
}

TEST(LabelOf, IsEmptyForWordsAndNumbers) {
  EXPECT_EQ(labelOf({.type = ItemType::LongText}, "because", "en"), "");
  EXPECT_EQ(labelOf({.type = ItemType::Number}, 0.0, "en"), "");
}

TEST(Keyed, ReversesItemsWordedAgainst) {
  const Item against{.key = -1};
  EXPECT_EQ(keyedPoint(against, 1), 5);
  EXPECT_EQ(keyedPoint(against, 3), 3);
  EXPECT_EQ(keyedPoint(against, 5), 1);
  EXPECT_EQ(keyedPoint({.key = -1, .scale = {.lowest = 0, .points = 7}}, 2), 4);
}

TEST(Keyed, LeavesTheOthersAsTheyAre) {
  EXPECT_EQ(keyedPoint({.key = 1}, 2), 2);
}

class UnansweredTest : public testing::Test {
 protected:
  std::vector<Item> items_{
      {.id = "a"},
      {.id = "b", .type = ItemType::LongText},
      {.id = "c", .type = ItemType::MultipleChoice},
      {.id = "d", .isRequired = false}};
};

TEST_F(UnansweredTest, NamesEveryRequiredItemInOrder) {
  EXPECT_EQ(unansweredItems(items_, {}), (Texts{"a", "b", "c"}));
}

TEST_F(UnansweredTest, TakesNoEmptyAnswerForAnAnswer) {
  const std::vector<Answer> empty{{"a", std::nullopt}, {"b", " \n\t"}, {"c", Texts{}}};
  EXPECT_EQ(unansweredItems(items_, empty), (Texts{"a", "b", "c"}));
}

TEST_F(UnansweredTest, ReportsNothingIfAllIsAnswered) {
  const std::vector<Answer> given{{"c", Texts{"x"}}, {"a", std::int64_t{1}}, {"b", "yes"}};
  EXPECT_TRUE(unansweredItems(items_, given).empty());
}

TEST_F(UnansweredTest, TakesZeroForAnAnswer) {
  EXPECT_TRUE(unansweredItems({{.id = "n", .type = ItemType::Number}}, {{"n", 0.0}}).empty());
}

/// A role, a question for surgeons, and one for those of them who operate on knees.
class ConditionTest : public testing::Test {
 protected:
  std::vector<Item> items_{
      {.id = "role", .type = ItemType::SingleChoice},
      {.id = "knees",
       .type = ItemType::MultipleChoice,
       .showIf = {.item = "role", .wantedOptions = {"surgeon", "resident"}}},
      {.id = "years",
       .type = ItemType::Number,
       .showIf = {.item = "knees", .wantedOptions = {"yes"}}}};
};

TEST_F(ConditionTest, AsksWhereOneOfTheOptionsWasChosen) {
  EXPECT_TRUE(isAsked(items_[0], items_, {}));
  EXPECT_FALSE(isAsked(items_[1], items_, {})) << "nothing was chosen yet";
  EXPECT_TRUE(isAsked(items_[1], items_, {{"role", "resident"}}));
  EXPECT_FALSE(isAsked(items_[1], items_, {{"role", "student"}}));
  EXPECT_FALSE(isAsked(items_[1], items_, {{"role", "surgeon"}, {"role", "student"}}))
      << "the last answer counts";
}

TEST_F(ConditionTest, AsksNothingAboutWhatIsItselfNotAsked) {
  const Answer knees{"knees", Texts{"hips", "yes"}};
  EXPECT_TRUE(isAsked(items_[2], items_, {{"role", "surgeon"}, knees}));
  EXPECT_FALSE(isAsked(items_[2], items_, {{"role", "student"}, knees}));
}

TEST_F(ConditionTest, RequiresNoAnswerToWhatIsNotAsked) {
  EXPECT_EQ(unansweredItems(items_, {}), (Texts{"role"}));
  EXPECT_EQ(unansweredItems(items_, {{"role", "surgeon"}}), (Texts{"knees"}));
  EXPECT_TRUE(unansweredItems(items_, {{"role", "student"}}).empty());
}

}  // namespace answer_test
}  // namespace questionnaires
