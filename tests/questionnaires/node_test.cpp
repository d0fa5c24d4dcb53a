#include <array>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "questionnaires/json/document.h"

namespace questionnaires {
namespace node_test {

class NodeTest : public testing::Test {
 protected:
  Node read(std::string_view json) {
    value_ = parseJson(json, problems_).value();
    return {value_, "$", problems_};
  }
  /// What was said, one line a problem; and forget it.
  std::string said() {
    std::string text = describe(problems_.all());
    problems_ = {};
    return text;
  }

 private:
  Value value_;
  Problems problems_;
};

constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();

TEST_F(NodeTest, TakesNoFractionForAWholeNumber) {
  EXPECT_EQ(read(R"({"n": 1.5})").wholeNumber("n", 0, 9, 7), 7);
  EXPECT_EQ(
      said(),
      "error   $.n: a whole number is expected here, not one with a decimal point; write it with "
      "digits only, without a decimal point\n");
}

TEST_F(NodeTest, TakesNeitherTruthNorTextForANumber) {
  EXPECT_EQ(read(R"({"n": true})").wholeNumber("n", 0, 9, 7), 7);
  EXPECT_NE(said().find("not true or false"), std::string::npos);
  EXPECT_EQ(read(R"({"n": "1"})").number("n", 0, 9, 7), 7);
  EXPECT_NE(said().find("not a text"), std::string::npos);
  EXPECT_EQ(read(R"({"n": null})").number("n", 0, 9, 7), 7);
  EXPECT_NE(said().find("not null"), std::string::npos);
}

TEST_F(NodeTest, SaysThatTheQuotationMarksOfANumberAreTheFault) {
  read(R"({"n": "8"})").wholeNumber("n", 0, 9, 7);
  EXPECT_TRUE(said().ends_with("; write it without quotation marks: 8\n"));
  read(R"({"n": "0,5"})").number("n", 0, 9, 7);
  EXPECT_TRUE(said().ends_with("; write it without quotation marks: 0.5\n"));
  read(R"({"n": "60 s"})").number("n", 0, 99, 7);
  EXPECT_TRUE(said().ends_with("; write the number alone, without quotation marks: 60\n"));
  read(R"({"n": "many"})").number("n", 0, 99, 7);
  EXPECT_TRUE(said().ends_with("not a text\n"));
  read(R"({"f": "yes"})").flag("f", false);
  EXPECT_TRUE(said().ends_with("; write true or false, without quotation marks\n"));
}

TEST_F(NodeTest, KnowsAWordByItsBeginning) {
  constexpr std::array kWords{
      Choice<int>{"none", 0}, Choice<int>{"bonferroni", 1}, Choice<int>{"holm", 2}};
  read(R"({"w": "holm-bonferroni"})").choice("w", kWords);
  const auto words = said();
  EXPECT_NE(words.find("did you mean 'holm'?"), std::string::npos) << words;
}

TEST_F(NodeTest, KeepsWholeNumbersThatADoubleCannot) {
  EXPECT_EQ(read(R"({"n": 9007199254740993})").wholeNumber("n", 0, kMost), 9007199254740993);
  EXPECT_EQ(read(R"({"n": 4294967297})").wholeNumber("n", 0, kMost), 4294967297);  // 2^32 + 1
  EXPECT_EQ(said(), "");
}

TEST_F(NodeTest, RefusesWholeNumbersThatAreTooLarge) {
  EXPECT_EQ(read(R"({"n": 18446744073709551615})").wholeNumber("n", 0, kMost, 7), 7);
  EXPECT_NE(said().find("a whole number is expected"), std::string::npos);
}

TEST_F(NodeTest, KnowsBothEndsOfARange) {
  EXPECT_EQ(read(R"({"n": 2})").wholeNumber("n", 2, 5), 2);
  EXPECT_EQ(read(R"({"n": 5})").number("n", 2, 5), 5);
  EXPECT_EQ(said(), "");
  read(R"({"n": 6})").wholeNumber("n", 2, 5);
  EXPECT_EQ(said(), "error   $.n: this number is out of range; write a whole number from 2 to 5\n");
  read(R"({"n": 5.01})").number("n", 0.5, 5);
  EXPECT_EQ(said(), "error   $.n: this number is out of range; write a number from 0.5 to 5\n");
}

TEST_F(NodeTest, NamesTheNearestKey) {
  EXPECT_TRUE(read(R"({"titel": 1})").isObjectWithOnlyKeys({"id", "title"}));
  EXPECT_EQ(said(), "error   $.titel: unknown key 'titel'; did you mean 'title'?\n");
}

TEST_F(NodeTest, ListsTheKeysWhereNoneIsNear) {
  EXPECT_TRUE(read(R"({"colour": 1})").isObjectWithOnlyKeys({"id", "title"}));
  EXPECT_EQ(said(), "error   $.colour: unknown key 'colour'; known here: id, title\n");
}

TEST_F(NodeTest, SaysOddKeysInOneLine) {
  const std::string key = "a\\nb" + std::string(10'000, 'x');
  EXPECT_TRUE(read("{\"" + key + "\": 1}").isObjectWithOnlyKeys({"id"}));
  const std::string text = said();
  EXPECT_LT(text.size(), 400U);
  EXPECT_EQ(text.find('\n'), text.size() - 1);
}

TEST_F(NodeTest, SaysWhatIsMissing) {
  const Node node = read("{}");
  EXPECT_EQ(node.text("a"), "");
  EXPECT_EQ(node.id("b"), "");
  EXPECT_FALSE(node.requiredObject("c").has_value());
  EXPECT_TRUE(node.requiredList("d").empty());
  EXPECT_EQ(
      said(),
      "error   $: 'a' is missing; add it\n"
      "error   $: 'b' is missing; add it\n"
      "error   $: 'c' is missing; add it\n"
      "error   $: 'd' is missing; add it\n");
}

TEST_F(NodeTest, AsksForNothingThatMayBeLeftOut) {
  const Node node = read("{}");
  EXPECT_EQ(node.text("a", "x"), "x");
  EXPECT_EQ(node.number("b", 0, 1, 0.5), 0.5);
  EXPECT_TRUE(node.flag("c", true));
  EXPECT_TRUE(node.list("d").empty());
  EXPECT_FALSE(node.object("e").has_value());
  EXPECT_FALSE(node.member("f").has_value());
  EXPECT_EQ(said(), "");
}

TEST_F(NodeTest, SaysWhichEntryOfAListIsWrong) {
  read(R"({"list": ["a", 1, "a b", "a"]})").ids("list");
  EXPECT_EQ(
      said(),
      "error   $.list[1]: a text is expected here, not a number; write \"…\"\n"
      "error   $.list[2]: 'a b' cannot be an id; use a letter or digit, then letters, digits, "
      "'.', '_' or '-', at most 64 in all\n"
      "error   $.list[3]: 'a' stands in this list twice; keep one\n");
}

TEST_F(NodeTest, OffersTheNearestOfSeveralNames) {
  constexpr std::array kChoices{Choice<int>{"mean", 1}, Choice<int>{"sum", 2}};
  EXPECT_EQ(read(R"({"a": "sum"})").choice("a", kChoices), 2);
  EXPECT_EQ(said(), "");
  read(R"({"a": "means"})").choice("a", kChoices);
  EXPECT_EQ(said(), "error   $.a: unknown word 'means'; did you mean 'mean'? one of: mean, sum\n");
}

}  // namespace node_test
}  // namespace questionnaires
