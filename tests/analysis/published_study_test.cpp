// The synthetic study of tests/data/stats/study: invented answers of the published structure,
// which round to the published Table 2 and vote as in Table 4.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/data/csv_table.h"
#include "analysis/data/vote_shares.h"
#include "analysis/hypothesis_tests/t_tests.h"
#include "analysis/numerics/distributions.h"
#include "analysis/summary/pairwise_comparisons.h"
#include "tests/analysis/digits.h"
#include "tests/analysis/golden_file.h"
#include "tests/support/test_data.h"

namespace published_study_test {

using analysis::LikertCounts;

/// Answers by cohort and method, as the codebook names the cells: PI, PF, PK, NI, NF, NK.
std::map<std::string, LikertCounts> pooledAnswers() {
  const std::map<std::string, std::string> letters{
      {"professional", "P"},
      {"non-professional", "N"},
      {"interpolation", "I"},
      {"fem", "F"},
      {"kalman", "K"}};
  const auto table = tests::statsTable("study/study_answers.csv");
  const auto cell = [&](const analysis::CsvRow& row, const char* column) {
    return row.cells[table.columnIndex(column)];
  };

  std::map<std::string, LikertCounts> cells;
  for (const auto& row : table.rows) {
    const auto answer = static_cast<int>(base::decimalNumber(cell(row, "answer")).value());
    const std::string name = letters.at(cell(row, "cohort")) + letters.at(cell(row, "method"));
    cells.try_emplace(name, 1, 5).first->second.add(cell(row, "key") == "-1" ? 6 - answer : answer);
  }
  return cells;
}

std::vector<analysis::NamedSample> cohort(
    const std::string& letter, const std::map<std::string, LikertCounts>& cells) {
  return {
      {"interpolation", cells.at(letter + "I")},
      {"fem", cells.at(letter + "F")},
      {"kalman", cells.at(letter + "K")}};
}

const std::vector<analysis::DeclaredPair> kDeclared{
    {"interpolation", "fem"}, {"interpolation", "kalman"}, {"kalman", "fem"}};

double toOneDecimal(double number) {
  return std::round(number * 10.0) / 10.0;
}

TEST(PublishedStudy, PoolsToTheCellsOfTheCodebook) {
  const auto cells = pooledAnswers();
  const auto golden = tests::statsJson("study/study_codebook.json")["cells"];

  ASSERT_EQ(cells.size(), 6U);
  ASSERT_EQ(golden.size(), 6U);
  for (const auto& [name, truth] : golden.items()) {
    SCOPED_TRACE(name);
    const auto& counts = cells.at(name);
    EXPECT_EQ(counts.total(), truth["n"].get<std::uint64_t>());
    EXPECT_TRUE(
        std::ranges::equal(counts.counts(), truth["counts"].get<std::vector<std::uint64_t>>()));
    EXPECT_GE(tests::correctDigits(counts.mean().value(), truth["mean"].dump()), 15.0);
    EXPECT_GE(tests::correctDigits(counts.variance().value(), truth["var"].dump()), 15.0);
  }
}

TEST(PublishedStudy, RoundsToTable2) {
  struct Printed {
    const char* cell;
    double mean;
    double variance;
  };
  const auto cells = pooledAnswers();
  for (const auto& [cell, mean, variance] :  // TABLE 2 of the punch paper
       {Printed{"PI", 4.1, 1.3},
        Printed{"PF", 2.6, 2.6},
        Printed{"PK", 3.2, 2.4},
        Printed{"NI", 4.1, 1.8},
        Printed{"NF", 3.0, 1.9},
        Printed{"NK", 3.3, 2.2}}) {
    EXPECT_DOUBLE_EQ(toOneDecimal(cells.at(cell).mean().value()), mean) << cell;
    EXPECT_DOUBLE_EQ(toOneDecimal(cells.at(cell).variance().value()), variance) << cell;
  }
}

TEST(PublishedStudy, AgreesWithThePipelineInR) {
  const auto cells = pooledAnswers();
  const auto golden = tests::statsJson("study/study_golden.json")["paper_welch"];
  tests::WorstDigits worst("the study, against 15 printed digits of R");

  ASSERT_EQ(golden.size(), 6U);
  std::size_t i = 0;
  for (const std::string letter : {"P", "N"}) {
    const auto groups = cohort(letter, cells);
    const auto family = analysis::comparePairwise(groups, kDeclared);
    for (const auto& row : family.rows) {
      const auto& truth = golden.at(i++);
      ASSERT_EQ(row.group1, truth["group1"].get<std::string>());
      ASSERT_EQ(row.group2, truth["group2"].get<std::string>());
      const auto check = [&](const std::string& quantity, double number, double gate) {
        const double digits = tests::correctDigits(number, truth[quantity].get<std::string>());
        worst.add(quantity, letter + " " + row.group1 + " " + row.group2, digits);
        EXPECT_GE(digits, gate) << quantity;
      };
      check("diff", row.estimate.value.value(), 13.0);
      check("t", row.statistic.value.value(), 13.0);
      check("df", row.df.value(), 13.0);
      check("p", row.p.value(), 12.0);
      const analysis::StudentDistribution toolpak(std::floor(row.df.value() + 0.5));
      check("p_toolpak", toolpak.twoSidedP(row.statistic.value.value()), 12.0);
      check("ci95_lo", row.interval.value().low, 12.0);
      check("ci95_hi", row.interval.value().high, 12.0);
      check("cib_lo", row.adjustedInterval.value().low, 12.0);
      check("cib_hi", row.adjustedInterval.value().high, 12.0);
      check("p_bonferroni", row.adjusted.value(), 12.0);
    }
  }
  EXPECT_EQ(worst.count(), 60);
}

TEST(PublishedStudy, FindsItsSignificantDifferences) {
  const auto cells = pooledAnswers();
  const auto professionals = analysis::comparePairwise(cohort("P", cells), kDeclared);
  const auto others = analysis::comparePairwise(cohort("N", cells), kDeclared);

  // p = .00005, .0087, .139 and .0029, .033, .42 against .05/3: study_golden.txt
  EXPECT_EQ(professionals.rows[0].isSignificant, true);
  EXPECT_EQ(professionals.rows[1].isSignificant, true);
  EXPECT_EQ(professionals.rows[2].isSignificant, false);
  EXPECT_EQ(others.rows[0].isSignificant, true);
  EXPECT_EQ(others.rows[1].isSignificant, false);
  EXPECT_EQ(others.rows[2].isSignificant, false);
}

TEST(PublishedStudy, VotesAsInTable4) {
  const auto table = tests::statsTable("study/study_preferences.csv");
  std::map<std::string, analysis::VoteCounts> votes;
  int missing = 0;
  for (const auto& row : table.rows) {
    const auto& preferred = row.cells[table.columnIndex("preferred")];
    const std::string place =
        row.cells[table.columnIndex("cohort")] + " " + row.cells[table.columnIndex("round")];
    auto& here =
        votes.try_emplace(place, std::vector<std::string>{"interpolation", "fem", "kalman"})
            .first->second;
    if (preferred.empty()) ++missing;
    if (!preferred.empty()) here.add(preferred);
  }
  const auto counts = [&](const std::string& place) {
    std::vector<std::uint64_t> numbers;
    for (const auto& share : votes.at(place).shares()) numbers.push_back(share.votes);
    return numbers;
  };

  using Numbers = std::vector<std::uint64_t>;
  EXPECT_EQ(counts("professional 1"), (Numbers{4, 0, 2}));  // TABLE 4 of the punch paper
  EXPECT_EQ(counts("professional 2"), (Numbers{3, 0, 2}));
  EXPECT_EQ(counts("non-professional 1"), (Numbers{2, 1, 2}));
  EXPECT_EQ(counts("non-professional 2"), (Numbers{2, 0, 3}));
  EXPECT_EQ(missing, 1);
}

}  // namespace published_study_test
