// Analyses of variance against the golden values of tests/data/stats and NIST's certified ones;
// the gates are those of the README there.
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/data/csv_table.h"
#include "analysis/hypothesis_tests/anova.h"
#include "analysis/reliability/reliability.h"
#include "tests/analysis/golden_check.h"
#include "tests/analysis/golden_file.h"
#include "tests/support/test_data.h"

namespace golden_anova_test {

using Table = std::vector<std::vector<double>>;

double numberIn(const std::string& cell) {
  return base::decimalNumber(cell).value();
}

/// One participant a row; the first column has their names.
Table blocksOf(const std::string& dataSet) {
  Table blocks;
  for (const auto& row : tests::statsTable("block/" + dataSet + ".csv").rows) {
    std::vector<double>& block = blocks.emplace_back();
    for (std::size_t i = 1; i < row.cells.size(); ++i) block.push_back(numberIn(row.cells[i]));
  }
  return blocks;
}

TEST(GoldenBlocks, MatchTheReferenceWithinTheirTolerance) {
  tests::WorstDigits worst("repeated measures");
  const auto gate = [](const std::string& quantity) {
    return quantity.find("_p") == std::string::npos ? 13.0 : 12.0;
  };
  int visited = 0;
  const auto all = tests::statsJson("golden.json")["block"];
  for (const auto& [dataSet, golden] : all.items()) {
    const auto result = analysis::repeatedMeasuresAnova(blocksOf(dataSet));
    ++visited;
    EXPECT_EQ(result.participants, golden["b"].get<std::size_t>());
    EXPECT_EQ(result.conditions, golden["k"].get<std::size_t>());
    if (dataSet == "b05_perfect_order") {  // left out of the golden file
      EXPECT_EQ(result.f, INFINITY);
      EXPECT_FALSE(result.p.has_value());
      EXPECT_FALSE(result.greenhouseGeisser.has_value());
      EXPECT_FALSE(result.reason.empty());
      continue;
    }
    const tests::Quantities ours{
        {"rm_anova_F", result.f},
        {"rm_anova_df1", result.degreesOfFreedom1},
        {"rm_anova_df2", result.degreesOfFreedom2},
        {"rm_anova_p", result.p},
        {"rm_partial_eta2", result.partialEtaSquared},
        {"gg_epsilon", result.greenhouseGeisser},
        {"rm_anova_p_gg", result.pGreenhouseGeisser}};
    tests::compareWithGolden(dataSet, golden, ours, gate, worst);
    EXPECT_NEAR(result.log10P.value(), std::log10(*result.p), 1e-13);
    EXPECT_TRUE(result.reason.empty()) << base::describe(result.reason);
  }
  EXPECT_EQ(visited, 4);
  EXPECT_EQ(worst.count(), 3 * 7);
}

Table nistGroups(const std::string& dataSet) {
  const auto table = tests::statsTable("nist/anova/" + dataSet + ".csv");
  const auto group = table.columnIndex("group");
  const auto y = table.columnIndex("y");
  std::map<std::string, std::vector<double>> groups;
  for (const auto& row : table.rows) groups[row.cells[group]].push_back(numberIn(row.cells[y]));
  Table values;
  for (const auto& entry : groups) values.push_back(entry.second);
  return values;
}

TEST(NistAnova, ReachesWhatDoublesCanAttain) {
  SKIP_WITHOUT_FETCHED_DATA("stats/nist/nist.json");
  tests::WorstDigits worst("NIST analysis of variance");
  int visited = 0;
  const auto all = tests::statsJson("nist/nist.json")["anova"];
  for (const auto& entry : all.items()) {
    const std::string& dataSet = entry.key();
    const auto& certified = entry.value();
    SCOPED_TRACE(dataSet);
    const auto result = analysis::oneWayAnova(nistGroups(dataSet));
    EXPECT_EQ(result.n, certified["n"].get<std::uint64_t>());
    EXPECT_EQ(result.degreesOfFreedom1, certified["df_between"].get<double>());
    EXPECT_EQ(result.degreesOfFreedom2, certified["df_within"].get<double>());
    tests::compareWithCertified(
        dataSet,
        certified,
        {{"f", result.f.value()},
         {"ss_between", result.squaresBetween.value()},
         {"ss_within", result.squaresWithin.value()}},
        worst);
    EXPECT_NEAR(
        std::pow(result.residualStandardDeviation.value(), 2) * *result.degreesOfFreedom2,
        *result.squaresWithin,
        1e-14 * *result.squaresWithin);
    EXPECT_NEAR(
        result.rSquared.value(),
        *result.squaresBetween / (*result.squaresBetween + *result.squaresWithin),
        1e-15);
    ++visited;
  }
  EXPECT_EQ(visited, 6);
  EXPECT_EQ(worst.count(), 6 * 3);
}

/// The scores of a cohort on the three statements about a method, one participant and round a row.
Table studyScores(const std::string& cohort, const std::string& method) {
  const auto table = tests::statsTable("study/study_answers.csv");
  const auto cell = [&](const analysis::CsvRow& row, const char* column) {
    return row.cells[table.columnIndex(column)];
  };
  std::map<std::string, std::map<std::string, double>> people;
  for (const auto& row : table.rows) {
    if (cell(row, "cohort") != cohort || cell(row, "method") != method) continue;
    const std::string person = cell(row, "participant") + "/" + cell(row, "round");
    people[person][cell(row, "statement")] = numberIn(cell(row, "score"));
  }
  Table scores;
  for (const auto& person : people) {
    auto& row = scores.emplace_back();
    for (const auto& score : person.second) row.push_back(score.second);
  }
  return scores;
}

TEST(StudyReliability, IsCronbachsAlphaOfR) {
  const auto golden = tests::statsJson("study/study_golden.json");
  const std::map<std::string, std::string> cohorts{
      {"prof", "professional"}, {"non", "non-professional"}};
  for (const auto& [key, cohort] : cohorts) {
    for (const std::string method : {"interpolation", "fem", "kalman"}) {
      const auto truth = golden["alpha_" + key + "_" + method].get<std::string>();
      const auto alpha = analysis::cronbachAlpha(studyScores(cohort, method));
      EXPECT_EQ(alpha.items, 3U);
      // R prints 15 digits
      EXPECT_GE(tests::correctDigits(alpha.value.value(), truth), 14.0) << key << " " << method;
    }
  }
}

}  // namespace golden_anova_test
