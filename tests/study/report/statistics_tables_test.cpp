#include "study/report/tables/statistics_tables.h"

#include <algorithm>
#include <span>

#include <gtest/gtest.h>

#include "study/results/apa_text.h"
#include "tests/study/report/section.h"

namespace study::report {
namespace statistics_tables_test {

/// The column of a table with this heading, as texts.
std::vector<std::string> column(const DataTable& table, const std::string& heading) {
  const auto found = std::ranges::find(table.columns, heading, &Heading::name);
  std::vector<std::string> texts;
  if (found == table.columns.end()) {
    ADD_FAILURE() << "no column " << heading;
    return texts;
  }
  for (const auto& row : table.rows) {
    texts.push_back(
        std::get<std::string>(row[static_cast<std::size_t>(found - table.columns.begin())]));
  }
  return texts;
}

TEST(StatisticsTables, HaveTheNumbersOfTheDeclaredTestsInTheirOrder) {
  const auto section = tests::madeUpSection();
  const auto table = statisticsTables(section, Profile::Declared).front();
  std::vector<std::string> p;
  std::vector<std::string> adjusted;
  for (const auto& part : section.results.families.front().cohorts) {
    for (const auto& test : part.comparisons.rows) {
      p.push_back(test.p ? formatP(test.p) : "");
      adjusted.push_back(test.adjusted ? formatP(test.adjusted) : "");
    }
  }
  EXPECT_EQ(column(table, "p"), p);
  EXPECT_EQ(column(table, "adjusted p"), adjusted);
}

TEST(StatisticsTables, SayHowManyPeopleGaveThePooledAnswers) {
  const auto section = tests::madeUpSection();
  const auto table = statisticsTables(section, Profile::Declared).front();
  std::vector<std::string> people;
  for (const auto& part : section.results.families.front().cohorts) {
    for (std::size_t i = 0; i < part.comparisons.rows.size(); ++i) {
      people.push_back(std::to_string(part.table.participants.size()));
    }
  }
  EXPECT_EQ(column(table, "People"), people);
  const auto within = statisticsTables(section, Profile::Recommended).front();
  EXPECT_EQ(std::ranges::count(within.columns, "People", &Heading::name), 0) << "n is of people";
}

TEST(StatisticsTables, HavePWithinPeopleBesideThatOfPooledAnswers) {
  const auto section = tests::madeUpSection();
  std::vector<std::string> within;
  for (const auto& part : section.results.families.front().cohorts) {
    for (const auto& pair : part.within.rows) {
      const auto& test = pair.test("paired_t");
      within.push_back(test.adjusted ? formatP(test.adjusted) : "–");
    }
  }
  ASSERT_TRUE(std::ranges::any_of(within, [](const auto& p) { return p != "–"; }));
  EXPECT_EQ(
      column(statisticsTables(section, Profile::Declared).front(), "p within people"), within);
  const auto table = statisticsTables(section, Profile::Recommended).front();
  EXPECT_EQ(std::ranges::count(table.columns, "p within people", &Heading::name), 0);
}

TEST(StatisticsTables, ListItemsByThemselvesButNotThoseOfOnePerson) {
  auto section = tests::madeUpSection();
  section.results.answers.items = {
      {.instrument = "punch-face-validity",
       .item = "1.1",
       .cohort = "professional",
       .condition = "kalman",
       .values = {3.0, 4.0},
       .mean = 3.5},
      {.instrument = "punch-face-validity",
       .item = "1.2",
       .cohort = "professional",
       .condition = "kalman",
       .values = {3.0},
       .mean = 3.0}};
  const auto tables = statisticsTables(section, Profile::Declared);
  const auto items = std::ranges::find(tables, "items", &DataTable::name);
  ASSERT_NE(items, tables.end());
  EXPECT_EQ(column(*items, "M"), std::vector<std::string>{"3.50"});
  EXPECT_EQ(column(*items, "People"), std::vector<std::string>{"2"});
}

TEST(StatisticsTables, SayWhyATestWasNotMade) {
  const auto section = tests::madeUpSection();
  const auto table = statisticsTables(section, Profile::Declared).front();
  const auto p = column(table, "p");
  const auto words = column(table, "In words");
  ASSERT_EQ(words.size(), p.size());
  ASSERT_TRUE(std::ranges::count(p, "") > 0) << "the section has a test that is not defined";
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_EQ(p[i].empty(), words[i].starts_with("Not tested: ")) << words[i];
  }
}

TEST(StatisticsTables, AreOfTextsWhereACohortHasNoAnswersYet) {
  auto section = tests::madeUpSection();
  for (auto& condition : section.results.families.front().cohorts.front().conditions) {
    condition.answers = analysis::AnswerSample(std::span<const double>());
  }
  const auto table = statisticsTables(section, Profile::Declared).front();
  const auto words = column(table, "In words");
  ASSERT_FALSE(words.empty());
  EXPECT_EQ(words.front(), "No answers yet.");
  for (const auto& row : table.rows) {
    EXPECT_EQ(row.size(), table.columns.size());
    for (const auto& cell : row) EXPECT_TRUE(std::holds_alternative<std::string>(cell));
  }
}

TEST(StatisticsTables, AreNoFormulasToASpreadsheetWhereATitleLooksLikeOne) {
  auto section = tests::madeUpSection();
  for (auto& condition : section.protocol.conditions) condition.title = "=1+1";
  for (const auto& table : statisticsTables(section, Profile::Declared)) {
    const auto csv = "\n" + asCsv(table);
    EXPECT_EQ(csv.find(",=1+1"), std::string::npos) << csv;
    EXPECT_EQ(csv.find(",\"=1+1"), std::string::npos) << csv;
    EXPECT_EQ(csv.find("\n=1+1"), std::string::npos) << csv;
  }
}

TEST(StatisticsTables, CallNoDeclaredTestExploratoryThatCouldNotBeMade) {
  auto section = tests::madeUpSection();
  auto& family = section.results.families.front();
  family.family.test = protocols::TestType::SignedRank;
  auto& row = family.cohorts.front().within.rows.front();
  auto& test = *std::ranges::find(row.tests, "signed_rank", &analysis::TestRow::id);
  test.p.reset();
  test.effect = {"rank_biserial", 1.0};
  test.reason = base::Message::verbatim("one pair only");
  const auto table = statisticsTables(section, Profile::Declared).front();
  const auto words = column(table, "In words");
  ASSERT_FALSE(words.empty());
  EXPECT_EQ(words.front(), "Not tested: one pair only.");
}

TEST(StatisticsTables, HaveTheDifferenceBesideADeclaredTestOfRanks) {
  auto section = tests::madeUpSection();
  auto& family = section.results.families.front();
  family.family.test = protocols::TestType::SignedRank;
  const auto table = statisticsTables(section, Profile::Declared).front();
  std::vector<std::string> differences;
  std::vector<std::string> p;
  for (const auto& part : family.cohorts) {
    for (const auto& pair : part.within.rows) {
      const auto& difference = pair.test("paired_t").estimate.value;
      differences.push_back(difference ? rounded(difference, 2) : "");
      const auto& test = pair.test("signed_rank");
      p.push_back(test.p ? formatP(test.p) : "");
    }
  }
  EXPECT_EQ(column(table, "Difference"), differences);
  EXPECT_EQ(column(table, "p"), p);
}

TEST(StatisticsTables, CallNothingSignificantThatWasNotDeclaredInTime) {
  auto section = tests::madeUpSection();
  const auto isAnySignificant = [&](Profile profile) {
    const auto words = column(statisticsTables(section, profile).front(), "In words");
    return std::ranges::any_of(
        words, [](const auto& text) { return text.starts_with("Significant: "); });
  };
  EXPECT_TRUE(isAnySignificant(Profile::Declared));
  EXPECT_FALSE(isAnySignificant(Profile::Recommended)) << "Welch's test is declared";
  section.results.families.front().isDeclared = false;
  EXPECT_FALSE(isAnySignificant(Profile::Declared));
}

}  // namespace statistics_tables_test
}  // namespace study::report
