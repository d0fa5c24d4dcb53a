// Compares the table of statistics with means computed from the table of responses.
#include "study/export/statistics_table.h"

#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/data/csv_table.h"
#include "study/cohort/simulated_participant.h"
#include "tests/study/exported_rows.h"
#include "tests/study/made_study.h"

namespace study {
namespace statistics_table_test {

using Row = tests::ExportedRow;
using Values = std::vector<double>;

double mean(const Values& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double deviation(const Values& values) {
  double squares = 0.0;
  for (const double value : values) squares += std::pow(value - mean(values), 2.0);
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

/// Eight simulated participants of two cohorts with their answers.
class StatisticsTableTest : public testing::Test {
 protected:
  StatisticsTableTest() {
    simulateCohorts(*study_, study_.clock, 8, 3, [](const auto&) {});
    const ExportOptions options{.runMode = RunMode::Simulated, .isBlinded = false};
    statistics_ = tests::rowsOf(statisticsTable(*study_, options, resultsFor(*study_, options)));
    for (const auto& table : exportTables(*study_, options)) {
      if (table.name == "responses") responses_ = tests::rowsOf(table);
    }
  }

  /// The scores of a cohort for a condition, by participant.
  std::map<std::string, Values> points(const Row& row, const std::string& code) const {
    std::map<std::string, Values> points;
    for (const auto& answer : responses_) {
      const bool counts = answer.at("cohort") == row.at("cohort") &&
                          answer.at("condition_code") == code &&
                          answer.at("instrument") == row.at("instrument") &&
                          answer.at("included") == "true" && !answer.at("response_keyed").empty();
      if (!counts) continue;
      points[answer.at("participant_id")].push_back(
          base::decimalNumber(answer.at("response_keyed")).value());
    }
    return points;
  }

  static Values pooled(const std::map<std::string, Values>& points) {
    Values all;
    for (const auto& [person, own] : points) all.insert(all.end(), own.begin(), own.end());
    return all;
  }

  static Values means(const std::map<std::string, Values>& points) {
    Values means;
    for (const auto& [person, own] : points) means.push_back(mean(own));
    return means;
  }

  static void expectNumber(const Row& row, const std::string& column, double expected) {
    const auto number = base::decimalNumber(row.at(column));
    ASSERT_TRUE(number.has_value()) << column << ": " << row.at(column);
    EXPECT_NEAR(*number, expected, 1e-9) << column;
  }

  std::vector<Row> rowsOfMethod(const std::string& method) const {
    std::vector<Row> rows;
    for (const auto& row : statistics_) {
      if (row.at("method") == method) rows.push_back(row);
    }
    return rows;
  }

  tests::MadeStudy study_{tests::libraryProtocol("punch-face-validity.json"), 1};
  std::vector<Row> statistics_;
  std::vector<Row> responses_;
};

TEST_F(StatisticsTableTest, HasTheMeansAndDeviationsOfItsGroups) {
  const auto rows = rowsOfMethod("welch");
  ASSERT_EQ(rows.size(), 6U);  // three comparisons in two cohorts
  for (const auto& row : rows) {
    SCOPED_TRACE(row.at("cohort") + " " + row.at("group1") + " " + row.at("group2"));
    const auto first = pooled(points(row, row.at("group1")));
    const auto second = pooled(points(row, row.at("group2")));
    ASSERT_GE(first.size(), 3U * 6U);  // each answers three statements in two rounds
    ASSERT_NE(mean(first), mean(second)) << "or this test would see no exchange";
    expectNumber(row, "n1", static_cast<double>(first.size()));
    expectNumber(row, "n2", static_cast<double>(second.size()));
    expectNumber(row, "mean1", mean(first));
    expectNumber(row, "mean2", mean(second));
    expectNumber(row, "sd1", deviation(first));
    expectNumber(row, "sd2", deviation(second));
    expectNumber(row, "estimate", mean(first) - mean(second));
    const double error = std::sqrt(
        std::pow(deviation(first), 2.0) / static_cast<double>(first.size()) +
        std::pow(deviation(second), 2.0) / static_cast<double>(second.size()));
    expectNumber(row, "se", error);
    expectNumber(row, "statistic", (mean(first) - mean(second)) / error);
  }
}

TEST_F(StatisticsTableTest, SubtractsTheSecondGroupFromTheFirstWithinPeople) {
  const auto rows = rowsOfMethod("paired_t");
  ASSERT_EQ(rows.size(), 6U);
  for (const auto& row : rows) {
    SCOPED_TRACE(row.at("cohort") + " " + row.at("group1") + " " + row.at("group2"));
    const auto first = means(points(row, row.at("group1")));
    const auto second = means(points(row, row.at("group2")));
    ASSERT_GE(first.size(), 3U);
    ASSERT_EQ(first.size(), second.size());
    const auto people = static_cast<double>(first.size());
    expectNumber(row, "mean1", mean(first));
    expectNumber(row, "mean2", mean(second));
    Values differences;
    for (std::size_t i = 0; i < first.size(); ++i) differences.push_back(first[i] - second[i]);
    ASSERT_NE(mean(differences), 0.0);
    const double error = deviation(differences) / std::sqrt(people);
    expectNumber(row, "n1", people);
    expectNumber(row, "estimate", mean(differences));
    expectNumber(row, "se", error);
    expectNumber(row, "statistic", mean(differences) / error);
    expectNumber(row, "df", people - 1.0);
  }
}

TEST_F(StatisticsTableTest, HasEveryIntervalAroundItsEstimateAndTheAdjustedOneWider) {
  int checked = 0;
  for (const auto* method : {"welch", "paired_t"}) {
    for (const auto& row : rowsOfMethod(method)) {
      const auto number = [&](const char* column) {
        return base::decimalNumber(row.at(column)).value();
      };
      EXPECT_LT(number("conf_low_adj"), number("conf_low"));
      EXPECT_LT(number("conf_low"), number("estimate"));
      EXPECT_LT(number("estimate"), number("conf_high"));
      EXPECT_LT(number("conf_high"), number("conf_high_adj"));
      EXPECT_LE(number("p"), number("p_adj"));
      ++checked;
    }
  }
  EXPECT_EQ(checked, 12);
}

TEST(StatisticsTableOfItems, HasNumbersAboutAPersonInExactExportsOnly) {
  tests::MadeStudy study(tests::protocolFrom(tests::shortProtocol({.form = "background"})));
  simulateCohorts(*study, study.clock, 2, 3, [](const auto&) {});
  for (const bool isExact : {false, true}) {
    const ExportOptions options{
        .runMode = RunMode::Simulated, .isBlinded = false, .isExact = isExact};
    std::map<std::string, int> times;
    for (const auto& row :
         tests::rowsOf(statisticsTable(*study, options, resultsFor(*study, options)))) {
      ++times[row.at("item_id")];
    }
    EXPECT_EQ(times["surgery-years"] > 0, isExact);
    EXPECT_GT(times["role"], 0);
  }
}

}  // namespace statistics_table_test
}  // namespace study
