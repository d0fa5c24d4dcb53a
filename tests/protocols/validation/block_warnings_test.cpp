// Orders, numbers of participants and statements that may mislead an analyst.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "protocols/model/messages.h"
#include "protocols/validation/validation.h"
#include "tests/protocols/small_protocol.h"

namespace protocols {
namespace block_warnings_test {

using Words = std::vector<std::string>;

/// What is said about a sound protocol, in short, but for what templates of the library lack, and
/// for what blinding_test.cpp asks about.
Words warningsOf(std::string_view json) {
  const auto loading = tests::load(json);
  EXPECT_TRUE(loading.loaded.has_value()) << loading.describe();
  Words said;
  for (const auto& problem : loading.problems) {
    EXPECT_EQ(problem.severity, questionnaires::Severity::Warning);
    EXPECT_FALSE(problem.fix.empty()) << base::describe(problem.what);
    const bool isOfBlinding =
        problem.what.key().ends_with("_tells") || problem.what.key().ends_with("_tell");
    if (problem.path.starts_with("$") && !isOfBlinding)
      said.push_back(problem.path + ": " + base::describe(problem.what));
  }
  return said;
}

/// usualProtocol() with an order of the block's, and so many participants planned.
std::string ordered(const std::string& type, int planned) {
  const auto text = tests::with(tests::usualProtocol(), "balancedLatinSquare", type);
  return tests::with(
      text, R"("title": "Anyone")", R"("title": "Anyone", "planned": )" + std::to_string(planned));
}

/// usualProtocol() that asks the published statements: 2.3 and 3.1 compare with the previous cut.
std::string published(const std::string& order, const std::string& sets) {
  const auto text =
      tests::with(tests::withBenchmark(tests::usualProtocol()), "balancedLatinSquare", order);
  const auto asked = tests::with(text, "realism-cuts", "punch-face-validity");
  return tests::with(
      asked,
      R"("questionnaires": [{ "instrument": "punch-face-validity" }])",
      R"("questionnaires": [{"instrument": "punch-face-validity", "set_by_condition": )" + sets +
          "}]");
}

const std::string kUnlike =
    "$.analysis.families[0]: conditions answer different statements in 'felt'";

std::string lacksPrevious(const std::string& item, const std::string& condition) {
  return "$.phases[2].questionnaires[0]: item '" + item + "' compares with the previous, and '" +
         condition + "' can come first in this block, where there is none";
}

TEST(BlockWarnings, WarnsOfOneOrderForAll) {
  const Words expected{"$.phases[1].order: everybody feels this block in the same order"};
  EXPECT_EQ(warningsOf(ordered("fixed", 8)), expected);
}

TEST(BlockWarnings, DoesNotWarnOfAFixedOrderOfOneCondition) {
  const auto text = tests::withPhases(
      {R"({"id": "alone", "type": "block", "conditions": ["soft"], "order": {"type": "fixed"},
           "minimum_cuts": 1})"});
  EXPECT_EQ(warningsOf(text), Words{});
}

TEST(BlockWarnings, SaysWhatNumberOfParticipantsBalancesADesign) {
  for (const auto* type : {"balancedLatinSquare", "latinSquare", "complete"}) {
    const auto loading = tests::load(ordered(type, 7));
    const auto& problem = loading.problems.back();
    EXPECT_EQ(problem.path, "$.phases[1].order") << loading.describe();
    EXPECT_EQ(problem.what, message("not_balanced", 7, "anyone"));
    EXPECT_EQ(problem.fix, message("not_balanced.fix", 2));
    EXPECT_EQ(warningsOf(ordered(type, 8)), Words{}) << type;
  }
}

TEST(BlockWarnings, AsksForTwiceAsManyWhereTheConditionsAreOdd) {
  auto text = tests::with(
      ordered("balancedLatinSquare", 9),
      "\"conditions\": [\n",
      "\"conditions\": [\n{\"id\": \"third\", \"title\": \"Third\", \"scene\": {\"device\": "
      "\"punch\", \"model\": \"interpolation\", \"parameters\": {}}},\n");
  text = tests::with(text, R"(["soft", "firm"])", R"(["soft", "firm", "third"])");
  const auto loading = tests::load(text);
  EXPECT_EQ(loading.problems.back().fix, message("not_balanced.fix", 6)) << loading.describe();
}

TEST(BlockWarnings, WarnsOfEveryCohortThatDoesNotBalance) {
  const auto text = tests::with(
      tests::usualProtocol(),
      R"([{ "id": "anyone", "title": "Anyone" }])",
      R"([{"id": "a", "title": "A", "planned": 3}, {"id": "b", "title": "B", "planned": 4},
          {"id": "c", "title": "C", "planned": 5}])");
  EXPECT_EQ(
      warningsOf(text),
      (Words{
          "$.phases[1].order: 3 participants of 'a' do not balance this design",
          "$.phases[1].order: 5 participants of 'c' do not balance this design"}));
}

TEST(BlockWarnings, SaysNothingOfBalanceWhereOrdersAreDrawnOrNoneIsPlanned) {
  EXPECT_EQ(warningsOf(ordered("random", 7)), Words{});
  EXPECT_EQ(warningsOf(ordered("complete", 0)), Words{});
}

TEST(BlockWarnings, WarnsOfNoPreviousCutWhereAnyConditionMayComeFirst) {
  EXPECT_EQ(
      warningsOf(published("latinSquare", R"({"soft": "1", "firm": "2"})")),
      (Words{lacksPrevious("2.3", "firm"), kUnlike}));
}

TEST(BlockWarnings, WarnsThatTheFirstConditionHasNoPreviousCutOnlyInAFixedOrder) {
  const std::string same = "$.phases[2].order: everybody feels this block in the same order";
  EXPECT_EQ(
      warningsOf(published("fixed", R"({"soft": "1", "firm": "2"})")), (Words{same, kUnlike}));
  EXPECT_EQ(
      warningsOf(published("fixed", R"({"soft": "2", "firm": "1"})")),
      (Words{lacksPrevious("2.3", "soft"), same, kUnlike}));
}

TEST(BlockWarnings, WarnsThatTheLastConditionHasNoPreviousCutWhereAnOrderIsReversed) {
  const auto text = tests::with(
      published("fixed", R"({"soft": "1", "firm": "2"})"),
      "\n  ],\n  \"analysis\"",
      R"(, {"id": "back", "type": "block", "conditions": ["soft", "firm"], "minimum_cuts": 1,
            "order": {"type": "reversed", "of": "felt"}, "questionnaires":
            [{"instrument": "punch-face-validity",
              "set_by_condition": {"soft": "2", "firm": "3"}}]})"
      "\n  ],\n  \"analysis\"");
  const auto said = warningsOf(text);
  const auto expected =
      "$.phases[3].questionnaires[0]: item '3.1' compares with the previous, and 'firm' can come "
      "first in this block, where there is none";
  EXPECT_EQ(
      said,
      (Words{
          "$.phases[2].order: everybody feels this block in the same order", expected, kUnlike}));
}

TEST(BlockWarnings, DoesNotWarnOfTheSameStatementsAfterEveryCondition) {
  EXPECT_EQ(warningsOf(published("random", R"({"soft": "1", "firm": "1"})")), Words{});
}

TEST(BlockWarnings, TakesAllItemsForAnotherSetThanOneOfThem) {
  const auto said = warningsOf(published("random", R"({"soft": "1"})"));
  EXPECT_EQ(said.back(), kUnlike);
}

TEST(BlockWarnings, LooksAtTheBlocksOfAFamilyOnly) {
  auto text = tests::with(
      published("random", R"({"soft": "1", "firm": "1"})"),
      "\n  ],\n  \"analysis\"",
      R"(, {"id": "unlike", "type": "block", "conditions": ["soft", "firm"], "minimum_cuts": 1,
            "order": {"type": "random"}, "questionnaires": [{"instrument": "punch-face-validity",
            "set_by_condition": {"soft": "1", "firm": "3"}}]})"
      "\n  ],\n  \"analysis\"");
  const std::string everywhere =
      "$.analysis.families[0]: conditions answer different statements in 'unlike'";
  EXPECT_EQ(warningsOf(text).back(), everywhere);
  text = tests::with(text, R"("comparisons")", R"("blocks": ["felt"], "comparisons")");
  for (const auto& words : warningsOf(text)) EXPECT_EQ(words.find("$.analysis"), std::string::npos);
}

TEST(BlockWarnings, WarnsOfAMissingPlanOfAnalysis) {
  const auto whole = tests::usualProtocol();
  const auto text = whole.substr(0, whole.find(",\n  \"analysis\"")) + "\n}";
  EXPECT_EQ(warningsOf(text), Words{"$.analysis: no family of comparisons is declared"});
}

TEST(BlockWarnings, WarnsOfAConfirmatoryTestOfPooledAnswers) {
  const auto text = tests::with(tests::usualProtocol(), "paired_t", "welch");
  const auto loading = tests::load(text);
  const auto& problem = loading.problems.back();
  EXPECT_EQ(problem.path, "$.analysis.families[0].test") << loading.describe();
  EXPECT_EQ(problem.what, message("pooled_answers"));
  EXPECT_EQ(problem.fix, message("pooled_answers.fix"));
}

TEST(BlockWarnings, DoesNotWarnOfTestsOfParticipantsMeans) {
  for (const auto* test : {"paired_t", "sign_flip", "signed_rank"}) {
    EXPECT_EQ(warningsOf(tests::with(tests::usualProtocol(), "paired_t", test)), Words{}) << test;
  }
}

}  // namespace block_warnings_test
}  // namespace protocols
