#include "study/report/tables/statistics_tables.h"

#include <algorithm>

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
        words, [](const auto& text) { return text.ends_with("was rated significantly higher."); });
  };
  EXPECT_TRUE(isAnySignificant(Profile::Declared));
  EXPECT_FALSE(isAnySignificant(Profile::Recommended)) << "Welch's test is declared";
  section.results.families.front().isDeclared = false;
  EXPECT_FALSE(isAnySignificant(Profile::Declared));
}

}  // namespace statistics_tables_test
}  // namespace study::report
