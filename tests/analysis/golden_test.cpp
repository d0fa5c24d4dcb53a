// The golden values of tests/data/stats: exact rational arithmetic and 60 digits, made by
// golden_exact.py beside them. The gates are those of the README there.
#include <algorithm>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/hypothesis_tests/t_tests.h"
#include "tests/analysis/golden_check.h"
#include "tests/analysis/golden_file.h"
#include "tests/support/test_data.h"

namespace golden_test {

using tests::addInterval;
using tests::Quantities;

constexpr double kConfidence95 = 0.95;
constexpr double kConfidenceBonferroni3 = 1.0 - 0.05 / 3.0;

Quantities quantitiesOf(const analysis::Moments& a, const analysis::Moments& b) {
  const auto welch = analysis::welchTTest(a, b);
  const auto student = analysis::studentTTest(a, b);
  Quantities quantities{
      {"n1", static_cast<double>(welch.n1)},
      {"n2", static_cast<double>(welch.n2)},
      {"mean1", welch.mean1},
      {"mean2", welch.mean2},
      {"var1", welch.variance1},
      {"var2", welch.variance2},
      {"diff", welch.difference},
      {"se_welch", welch.standardError},
      {"t_welch", welch.t},
      {"df_welch", welch.degreesOfFreedom},
      {"p_welch", welch.p},
      {"p_welch_less", welch.pLess},
      {"p_welch_greater", welch.pGreater},
      {"log10_p_welch", welch.log10P},
      {"t_student", student.t},
      {"df_student", student.degreesOfFreedom},
      {"p_student", student.p}};
  addInterval(quantities, "ci95_welch", confidenceInterval(welch, kConfidence95));
  addInterval(quantities, "cibonf3_welch", confidenceInterval(welch, kConfidenceBonferroni3));
  return quantities;
}

double gateOf(const std::string& quantity) {
  if (quantity.starts_with("p_") || quantity.starts_with("ci")) return 12.0;
  if (quantity.starts_with("log10_p")) return 9.0;
  return 13.0;
}

TEST(GoldenTwoSamples, MatchTheReferenceWithinTheirTolerance) {
  const auto golden = tests::statsJson("golden.json")["two"];
  tests::WorstDigits worst("two samples");

  int visited = 0;
  for (const auto& [dataSet, truth] : golden.items()) {
    const auto groups = tests::statsGroups(dataSet);
    auto ours = quantitiesOf(
        analysis::momentsOf(groups.group1.values), analysis::momentsOf(groups.group2.values));
    if (!truth.contains("t_student")) ours.erase("t_student");  // t07: ±inf, left out
    tests::compareWithGolden(dataSet, truth, ours, gateOf, worst);
    ++visited;
  }

  EXPECT_EQ(visited, 15);
  // 15 sets × 21 quantities; t07 has no df, p, limits, nor a finite t; t15 no variances.
  EXPECT_EQ(worst.count(), 15 * 21 - 13 - 2);
}

TEST(GoldenTwoSamples, CoverEveryDataSet) {
  const auto golden = tests::statsJson("golden.json")["two"];

  std::set<std::string> files;
  for (const auto& file : std::filesystem::directory_iterator(tests::testData("stats/two"))) {
    files.insert(file.path().stem().string());
  }

  std::set<std::string> dataSets;
  for (const auto& entry : golden.items()) dataSets.insert(entry.key());
  EXPECT_EQ(files, dataSets);
}

TEST(GoldenTwoSamples, GiveAReasonForMissingValues) {
  const auto golden = tests::statsJson("golden.json")["two"];
  for (const auto& entry : golden.items()) {
    const auto groups = tests::statsGroups(entry.key());
    const auto result = analysis::welchTTest(groups.group1.values, groups.group2.values);
    const bool isComplete = result.variance1 && result.variance2 && result.p;

    EXPECT_EQ(result.reason.empty(), isComplete)
        << entry.key() << ": " << base::describe(result.reason);
  }
}

/// Knuth's MMIX generator, as big.json describes it.
analysis::LikertCounts generated(const nlohmann::json& recipe) {
  analysis::LikertCounts counts(1, 5);
  auto state = recipe["seed"].get<std::uint64_t>();
  const auto cumulative = recipe["cum"].get<std::vector<double>>();
  for (int i = 0; i < recipe["n"].get<int>(); ++i) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    const double uniform = static_cast<double>(state >> 11) * 0x1p-53;
    int answer = 1;
    for (const double bound : cumulative) answer += uniform >= bound ? 1 : 0;
    counts.add(answer);
  }
  return counts;
}

std::vector<double> unfolded(const analysis::LikertCounts& counts) {
  std::vector<double> values;
  double point = counts.lowest();
  for (const auto times : counts.counts()) values.insert(values.end(), times, point++);
  return values;
}

TEST(GoldenMillion, MatchesTheReferenceFromCountsAndFromValues) {
  const auto recipe = tests::statsJson("big.json")["sets"].at(0);
  const auto golden = tests::statsJson("golden.json")["big"]["big_1e6"];
  const auto a = generated(recipe["a"]);
  const auto b = generated(recipe["b"]);
  const auto histogram = recipe["a"]["counts_1_to_5"].get<std::vector<std::uint64_t>>();
  ASSERT_TRUE(std::ranges::equal(a.counts(), histogram));

  tests::WorstDigits worst("a million answers");
  const std::set<std::string> wanted{
      "n1",
      "n2",
      "mean1",
      "mean2",
      "var1",
      "var2",
      "t_welch",
      "df_welch",
      "p_welch",
      "ci95_welch_lo",
      "ci95_welch_hi"};
  const auto only = [&](Quantities quantities) {
    std::erase_if(quantities, [&](const auto& entry) { return !wanted.contains(entry.first); });
    return quantities;
  };
  const auto compare = [&](const std::string& from, const auto& moments1, const auto& moments2) {
    const auto ours = only(quantitiesOf(moments1, moments2));
    tests::compareWithGolden(from, golden, ours, gateOf, worst);
  };
  compare("counts", momentsOf(a), momentsOf(b));
  compare("values", analysis::momentsOf(unfolded(a)), analysis::momentsOf(unfolded(b)));
  EXPECT_EQ(worst.count(), 2 * 11);
}

}  // namespace golden_test
