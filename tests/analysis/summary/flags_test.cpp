#include "analysis/summary/flags.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/summary/answer_checks.h"

namespace flags_test {

using analysis::AnswerTable;
using analysis::StudyFacts;

/// Six people, two methods in two orders, two statements each: nothing to be said but that there
/// are two answers of each.
AnswerTable balanced() {
  AnswerTable table;
  table.participants = {"P1", "P2", "P3", "P4", "P5", "P6"};
  table.methods = {"a", "b"};
  table.rounds = {"first"};
  table.statements = {"1", "2"};
  for (std::size_t person = 0; person < 6; ++person) {
    for (std::size_t method = 0; method < 2; ++method) {
      for (std::size_t statement = 0; statement < 2; ++statement) {
        const int score = 3 + static_cast<int>((person + method + statement) % 3) - 1;
        const int position = (person + method) % 2 == 0 ? 1 : 2;
        table.answers.push_back({person, method, 0, statement, position, double(score)});
      }
    }
  }
  return table;
}

std::vector<std::string> idsOf(const AnswerTable& table, const StudyFacts& facts) {
  std::vector<std::string> ids;
  for (const auto& flag : analysis::flagsOf(table, facts)) {
    ids.emplace_back(flag.id);
    EXPECT_FALSE(flag.inEnglish().empty() || flag.why.empty() || flag.remedy.empty()) << flag.id;
    EXPECT_FALSE(flag.source.empty()) << flag.id;
  }
  return ids;
}

using Ids = std::vector<std::string>;

const StudyFacts kSound{.isPooled = false, .tests = 1};

TEST(Flags, AreNotRaisedWithoutReason) {
  EXPECT_EQ(idsOf(balanced(), kSound), Ids{});
}

TEST(Flags, NamePoolingAndPairing) {
  EXPECT_EQ(
      idsOf(balanced(), {.isPooled = true, .tests = 1}),
      (Ids{"pseudo_replication", "paired_data_unpaired_test"}));
}

TEST(Flags, OmitPoolingIfEachParticipantGaveOneAnswer) {
  auto table = balanced();
  std::erase_if(table.answers, [](const auto& answer) { return answer.statement == 1; });
  EXPECT_EQ(idsOf(table, {.isPooled = true, .tests = 1}), Ids{"paired_data_unpaired_test"});
}

TEST(Flags, NameStatementsThatDiffer) {
  auto facts = kSound;
  facts.hasSameStatements = false;
  EXPECT_EQ(idsOf(balanced(), facts), Ids{"items_not_common_to_methods"});
}

TEST(Flags, OmitStatementsThatNobodyAnsweredAboutAMethod) {
  auto table = balanced();
  std::erase_if(
      table.answers, [](const auto& one) { return one.method == 1 && one.statement == 1; });
  EXPECT_EQ(idsOf(table, kSound), Ids{});
}

/// What was felt where everybody answers.
std::vector<analysis::Felt> feltIn(const AnswerTable& table) {
  std::vector<analysis::Felt> felt;
  for (const auto& one : table.answers) {
    felt.push_back({one.participant, one.method, one.round, one.position});
  }
  return felt;
}

TEST(Flags, NameStatementsThatCompare) {
  auto facts = kSound;
  facts.comparativeStatements = {1};
  const auto flags = analysis::flagsOf(balanced(), facts);
  ASSERT_EQ(flags.size(), 1U);
  EXPECT_EQ(flags[0].id, "relative_item_without_referent");
  EXPECT_NE(flags[0].inEnglish().find(": 2."), std::string::npos);
}

TEST(Flags, NameOneOrderForAllParticipants) {
  auto table = balanced();
  for (auto& answer : table.answers) answer.position = static_cast<int>(answer.method) + 1;
  auto facts = kSound;
  facts.felt = feltIn(table);
  EXPECT_EQ(idsOf(table, facts), Ids{"order_not_counterbalanced"});
  // … and then the other way round: every method equally often at every place.
  auto mirrored = table;
  mirrored.rounds.emplace_back("second");
  for (auto answer : table.answers) {
    answer.round = 1;
    answer.position = 3 - answer.position;
    mirrored.answers.push_back(answer);
  }
  facts.felt = feltIn(mirrored);
  EXPECT_EQ(idsOf(mirrored, facts), Ids{});
}

TEST(Flags, AllowATwentiethOfManyPeople) {
  const auto felt = [](std::size_t people, std::size_t firstOrder) {
    std::vector<analysis::Felt> all;
    for (std::size_t person = 0; person < people; ++person) {
      const int position = person < firstOrder ? 1 : 2;
      all.push_back({person, 0, 0, position});
      all.push_back({person, 1, 0, 3 - position});
    }
    return all;
  };
  auto facts = kSound;
  facts.felt = felt(102, 52);
  EXPECT_EQ(idsOf(balanced(), facts), Ids{});
  facts.felt = felt(12, 7);
  EXPECT_EQ(idsOf(balanced(), facts), Ids{"order_not_counterbalanced"});
}

TEST(Flags, CountOrdersByWhatWasFeltNotByAnswers) {
  auto table = balanced();
  auto facts = kSound;
  facts.felt = feltIn(table);
  std::erase_if(
      table.answers, [](const auto& one) { return one.method == 1 && one.participant % 2 == 0; });
  facts.threshold = 1.0;
  EXPECT_EQ(idsOf(table, facts), Ids{});
}

TEST(Flags, NameBimodalAndConstantGroups) {
  auto table = balanced();
  for (auto& answer : table.answers) {
    answer.score = answer.method == 0 ? (answer.participant % 2 == 0 ? 1 : 5) : 4;
  }
  EXPECT_EQ(idsOf(table, kSound), (Ids{"bimodal", "constant_group"}));
}

TEST(Flags, NameTooFewPeopleForTheFamily) {
  auto facts = kSound;
  facts.tests = 3;  // 2/2⁶ = .03125 > .05/3
  EXPECT_EQ(idsOf(balanced(), facts), Ids{"n_below_minimum_for_alpha"});
}

TEST(Flags, JudgeTooFewPeopleByCompletePairs) {
  auto table = balanced();
  std::erase_if(table.answers, [](const auto& answer) {
    return answer.participant > 0 && answer.method == answer.participant % 2;
  });
  const auto flags = analysis::flagsOf(table, kSound);
  const auto few = std::find_if(flags.begin(), flags.end(), [](const auto& flag) {
    return flag.id == "n_below_minimum_for_alpha";
  });
  ASSERT_NE(few, flags.end());
  EXPECT_EQ(few->inEnglish().find("With 1 person who judged both methods of a pair no"), 0U);
}

TEST(Flags, AllowADifferenceOfOneForEachRound) {
  auto table = balanced();
  std::erase_if(table.answers, [](const auto& answer) { return answer.participant > 0; });
  for (auto& answer : table.answers) answer.position = static_cast<int>(answer.method) + 1;
  auto facts = kSound;
  facts.threshold = 1.0;
  facts.felt = feltIn(table);
  EXPECT_EQ(idsOf(table, facts), Ids{});
  table.rounds.emplace_back("second");
  const auto first = table.answers;
  for (auto answer : first) {
    answer.round = 1;
    table.answers.push_back(answer);
  }
  facts.felt = feltIn(table);
  EXPECT_EQ(idsOf(table, facts), Ids{});
}

TEST(Flags, UseTheCorrectionsThresholdForTheSmallestP) {
  auto facts = kSound;
  facts.tests = 3;
  facts.threshold = 0.05;  // every p for itself
  EXPECT_EQ(idsOf(balanced(), facts), Ids{});
}

TEST(Flags, NamePoolingAlsoWithManyMissingAnswers) {
  auto table = balanced();
  table.answers = {{0, 0, 0, 0, 1, 3}, {0, 0, 0, 1, 1, 3}, {1, 1, 0, 0, 1, 4}};
  const auto ids = idsOf(table, {.isPooled = true, .threshold = 1.0, .tests = 1});
  EXPECT_EQ(std::count(ids.begin(), ids.end(), "pseudo_replication"), 1);
}

TEST(Flags, NameAThresholdThatRoundingMoves) {
  auto facts = kSound;
  facts.tests = 3;
  facts.alpha = 0.1;  // 0.0333… rounds down to 0.033
  facts.pValues = {0.5, 0.03315};
  EXPECT_EQ(idsOf(balanced(), facts), Ids{"alpha_rounded"});
  facts.pValues = {0.5, 0.0329};
  EXPECT_EQ(idsOf(balanced(), facts), Ids{});
}

TEST(Flags, CountMissingAnswers) {
  auto table = balanced();
  table.answers.pop_back();
  auto facts = kSound;
  facts.expected = {2, 2};
  const auto flags = analysis::flagsOf(table, facts);
  ASSERT_EQ(flags.size(), 1U);
  EXPECT_EQ(flags[0].id, "missing_cells");
  EXPECT_EQ(flags[0].inEnglish().rfind("1 of 24 answers is missing, in 1 of 12", 0), 0U)
      << flags[0].inEnglish();
}

TEST(Flags, NameTrialsThatWereNotRenderedAsMeant) {
  auto facts = kSound;
  facts.trials = 12;
  facts.lateTrials = 2;
  facts.saturated = {{"Recording", 3, 4}, {"Model", 1, 4}};
  EXPECT_EQ(idsOf(balanced(), facts), (Ids{"late_ticks", "saturated"}));
  EXPECT_EQ(
      analysis::flagsOf(balanced(), facts)[1].inEnglish(),
      "In 4 of 12 trials the scene asked for more force than the device may give: “Recording” in 3 "
      "of 4, “Model” in 1 of 4.");
}

TEST(Flags, HaveTitlesForPeople) {
  auto facts = kSound;
  facts.trials = 12;
  facts.lateTrials = 2;
  EXPECT_EQ(base::describe(analysis::flagsOf(balanced(), facts)[0].title()), "A late force loop");
  std::set<std::string> ids;
  for (const auto& kind : analysis::kFlagMessages) {
    if (kind.key.ends_with(".remedy"))
      ids.insert(std::string(kind.key.substr(0, kind.key.rfind('.'))));
  }
  for (const auto& id : ids) {
    EXPECT_FALSE(base::describe(analysis::Flag{.id = id}.title()).empty()) << id;
  }
}

TEST(Flags, NameAnUndeclaredFamilyEvenWithoutAnswers) {
  AnswerTable empty;
  empty.methods = {"a", "b"};
  EXPECT_EQ(idsOf(empty, {.isDeclared = false}), Ids{"family_not_declared"});
}

TEST(AnswerDependence, IsOneIfEachPersonAlwaysAnswersTheSame) {
  auto table = balanced();
  for (auto& answer : table.answers) answer.score = 1 + static_cast<int>(answer.participant % 5);
  const auto dependence = analysis::dependenceOf(table);
  EXPECT_EQ(dependence.answers, 24U);
  EXPECT_EQ(dependence.participants, 6U);
  EXPECT_NEAR(dependence.intraclassCorrelation.value(), 1.0, 1e-12);
  EXPECT_NEAR(dependence.designEffect.value(), 2.0, 1e-12);
}

// Shrout & Fleiss 1979, Table 2: six targets, four judges; ICC(1, 1) = .17.
TEST(AnswerDependence, IsThePublishedOne) {
  const int ratings[6][4] = {
      {9, 2, 5, 8}, {6, 1, 3, 2}, {8, 4, 6, 8}, {7, 1, 2, 6}, {10, 5, 6, 9}, {6, 2, 4, 7}};
  AnswerTable table;
  table.lowest = 1;
  table.highest = 10;
  table.participants = {"1", "2", "3", "4", "5", "6"};
  table.methods = {"m"};
  table.statements = {"1", "2", "3", "4"};
  for (std::size_t target = 0; target < 6; ++target) {
    for (std::size_t judge = 0; judge < 4; ++judge) {
      table.answers.push_back({target, 0, 0, judge, 1, double(ratings[target][judge])});
    }
  }
  EXPECT_NEAR(analysis::dependenceOf(table).intraclassCorrelation.value(), 0.1657, 5e-5);
}

TEST(AnswerDependence, IsUndefinedIfAllAnswersAreEqual) {
  auto table = balanced();
  for (auto& answer : table.answers) answer.score = 3;
  EXPECT_EQ(analysis::dependenceOf(table).intraclassCorrelation, std::nullopt);
}

}  // namespace flags_test
