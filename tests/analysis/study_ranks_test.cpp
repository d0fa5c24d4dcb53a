// The participants of the synthetic study of tests/data/stats/study, compared within themselves:
// against R (study_golden.R), which took differences to ten decimals.
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/data/csv_table.h"
#include "analysis/hypothesis_tests/attainable_p.h"
#include "analysis/hypothesis_tests/friedman.h"
#include "analysis/hypothesis_tests/sign_tests.h"
#include "analysis/numerics/exact_arithmetic.h"
#include "tests/analysis/digits.h"
#include "tests/analysis/golden_file.h"
#include "tests/support/test_data.h"

namespace study_ranks_test {

/// Mean score by cohort and method, a value per participant in the order of the file.
std::map<std::string, std::vector<double>> participantMeans() {
  const auto table = tests::statsTable("study/study_answers.csv");
  const auto cell = [&](const analysis::CsvRow& row, const char* column) {
    return row.cells[table.columnIndex(column)];
  };
  struct Sum {
    double sum = 0.0;
    double count = 0.0;
  };
  std::map<std::string, std::map<std::string, Sum>> sums;
  for (const auto& row : table.rows) {
    auto& sum = sums[cell(row, "cohort") + " " + cell(row, "method")][cell(row, "participant")];
    sum.sum += base::decimalNumber(cell(row, "score")).value();
    sum.count += 1.0;
  }
  std::map<std::string, std::vector<double>> means;
  for (const auto& [place, participants] : sums) {
    for (const auto& [name, sum] : participants) means[place].push_back(sum.sum / sum.count);
  }
  return means;
}

TEST(StudyWithinParticipants, AgreesWithR) {
  const auto means = participantMeans();
  const auto golden = tests::statsJson("study/study_golden.json")["within"];
  ASSERT_EQ(golden.size(), 6U);
  for (const auto& truth : golden) {
    const auto cohort = truth["cohort"].get<std::string>();
    const auto& x = means.at(cohort + " " + truth["group1"].get<std::string>());
    const auto& y = means.at(cohort + " " + truth["group2"].get<std::string>());
    std::vector<double> differences;
    for (std::size_t i = 0; i < x.size(); ++i) differences.push_back(x[i] - y[i]);

    const auto flip = analysis::signFlipTest(differences);
    const auto rank = analysis::signedRankTest(analysis::withoutRoundingNoise(differences));
    const auto digits = [&](const char* name, double number) {
      return tests::correctDigits(number, truth[name].get<std::string>());
    };
    EXPECT_GE(digits("p_signflip_exact", flip.p.value()), 14.0) << truth;
    EXPECT_GE(digits("p_wilcoxon_exact", rank.p.value()), 14.0) << truth;
    EXPECT_GE(digits("p_min_attainable", analysis::smallestSignFlipP(x.size()).p), 14.0);
    EXPECT_DOUBLE_EQ(rank.v.value(), truth["V"].get<double>());
  }
}

TEST(StudyWithinParticipants, HasTheFriedmanTestOfR) {
  const auto means = participantMeans();
  const auto golden = tests::statsJson("study/study_golden.json")["friedman"];
  ASSERT_EQ(golden.size(), 2U);
  for (const auto& truth : golden) {
    const auto cohort = truth["cohort"].get<std::string>();
    std::vector<std::vector<double>> blocks(means.at(cohort + " fem").size());
    for (const char* method : {" interpolation", " fem", " kalman"}) {
      const auto& column = means.at(cohort + method);
      for (std::size_t i = 0; i < column.size(); ++i) blocks[i].push_back(column[i]);
    }
    const auto result = analysis::friedmanTest(blocks);
    const auto digits = [&](const char* name, double number) {
      return tests::correctDigits(number, truth[name].get<std::string>());
    };
    EXPECT_GE(digits("chi2", result.chiSquared.value()), 14.0);
    EXPECT_GE(digits("p", result.p.value()), 12.0);
    EXPECT_GE(digits("kendall_W", result.kendallW.value()), 14.0);
  }
}

}  // namespace study_ranks_test
