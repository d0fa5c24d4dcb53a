// NIST's certified values, and the golden p values and votes of tests/data/stats.
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/data/csv_table.h"
#include "analysis/data/moments.h"
#include "analysis/hypothesis_tests/adjustment.h"
#include "analysis/hypothesis_tests/vote_tests.h"
#include "tests/analysis/golden_check.h"
#include "tests/analysis/golden_file.h"
#include "tests/support/test_data.h"

namespace golden_lists_test {

std::vector<double> nistValues(const std::string& dataSet) {
  const auto table = tests::statsTable("nist/univariate/" + dataSet + ".csv");
  const auto column = table.columnIndex("y");
  std::vector<double> values;
  for (const auto& row : table.rows) {
    values.push_back(base::decimalNumber(row.cells[column]).value());
  }
  return values;
}

TEST(NistUnivariate, ReachesWhatDoublesCanAttain) {
  SKIP_WITHOUT_FETCHED_DATA("stats/nist/nist.json");
  tests::WorstDigits worst("NIST");

  int visited = 0;
  const auto all = tests::statsJson("nist/nist.json")["univariate"];
  for (const auto& entry : all.items()) {
    const std::string& dataSet = entry.key();
    const auto& certified = entry.value();
    SCOPED_TRACE(dataSet);
    const auto summary = analysis::summarise(nistValues(dataSet));
    EXPECT_EQ(summary.n, certified["n"].get<std::uint64_t>());
    tests::compareWithCertified(
        dataSet,
        certified,
        {{"mean", summary.mean.value()}, {"sd", summary.standardDeviation.value()}},
        worst);
    ++visited;
  }
  EXPECT_EQ(visited, 5);
}

std::vector<std::optional<double>> pValues(const std::string& dataSet) {
  const auto table = tests::statsTable("padj/" + dataSet + ".csv");
  std::vector<std::optional<double>> values;
  for (const auto& row : table.rows) values.push_back(base::decimalNumber(row.cells.front()));
  return values;
}

/// What the golden file calls a method.
std::string goldenName(analysis::Adjustment method) {
  using enum analysis::Adjustment;
  if (method == BenjaminiHochberg) return "BH";
  if (method == BenjaminiYekutieli) return "BY";
  if (method == HolmSidak) return "holm_sidak";
  return std::string(nameOf(method));
}

TEST(GoldenAdjustments, MatchTheReference) {
  tests::WorstDigits worst("adjusted p values");

  int visited = 0;
  const auto all = tests::statsJson("golden.json")["padj"];
  for (const auto& [dataSet, golden] : all.items()) {
    for (const auto method : analysis::kAdjustments) {
      const std::string name = goldenName(method);
      SCOPED_TRACE(testing::Message() << dataSet << " " << name);
      const auto& truth = golden[name];
      const auto adjusted = analysis::adjust(pValues(dataSet), method);

      ASSERT_EQ(adjusted.size(), truth.size());
      for (std::size_t i = 0; i < adjusted.size(); ++i) {
        ASSERT_EQ(adjusted[i].has_value(), !truth[i].is_null());
        if (!adjusted[i]) continue;
        const double digits = tests::correctDigits(*adjusted[i], truth[i].get<std::string>());
        worst.add(name, dataSet, digits);
        EXPECT_GE(digits, 14.0);
      }
    }
    ++visited;
  }
  EXPECT_EQ(visited, 5);
  EXPECT_EQ(worst.count(), (3 + 5 + 1 + 3 + 15) * 7);
}

TEST(GoldenVotes, GiveTheExactMultinomialP) {
  const auto golden = tests::statsJson("golden.json")["counts"];
  tests::WorstDigits worst("votes");

  int visited = 0;
  const auto all = tests::statsJson("counts.json");
  for (const auto& entry : all.items()) {
    const std::string& dataSet = entry.key();
    analysis::VoteCounts votes({"I", "F", "K"});
    for (const auto& [option, count] : entry.value().items())
      votes.add(option, count.get<unsigned>());
    const auto& truth = golden[dataSet];
    const auto check = [&](const std::string& quantity, double number) {
      const double digits = tests::correctDigits(number, truth[quantity].get<std::string>());
      worst.add(quantity, dataSet, digits);
      EXPECT_GE(digits, 14.0) << dataSet << " " << quantity;
    };

    check("p_multinomial_exact", analysis::equalSharesP(votes).value());
    for (const auto& share : votes.shares()) check(share.option + "_share", share.share.value());
    ++visited;
  }
  EXPECT_EQ(visited, 4);
}

}  // namespace golden_lists_test
