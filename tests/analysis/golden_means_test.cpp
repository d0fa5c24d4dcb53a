// Effect sizes, equivalence, Bayes factors and the paired t test against the golden values of
// tests/data/stats; the gates are those of the README there.
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/data/csv_table.h"
#include "analysis/effects/bayes_factor.h"
#include "analysis/effects/effect_size.h"
#include "analysis/hypothesis_tests/t_tests.h"
#include "tests/analysis/golden_check.h"
#include "tests/analysis/golden_file.h"
#include "tests/support/test_data.h"

namespace golden_means_test {

using tests::addInterval;
using tests::Quantities;

constexpr analysis::EquivalenceBounds kHalfAPoint{.lower = -0.5, .upper = 0.5};

double gateOf(const std::string& quantity) {
  if (quantity.starts_with("bf10")) return 9.0;
  if (quantity.starts_with("log10")) return 9.0;
  const bool isProbability = quantity.starts_with("p_") || quantity.starts_with("cles");
  if (isProbability || quantity.find("ci95") != std::string::npos) return 12.0;
  return 13.0;
}

Quantities effectsOf(const std::vector<double>& a, const std::vector<double>& b) {
  const auto effects = analysis::effectSizes(a, b);
  const auto student = analysis::studentTTest(a, b);
  Quantities quantities{
      {"cohen_d", effects.cohenD.value},
      {"hedges_g", effects.hedgesG.value},
      {"cohen_d_av", effects.cohenDAv.value},
      {"hedges_g_av_welchdf", effects.hedgesGAv.value},
      {"glass_delta_sd2", effects.glassDelta2},
      {"cles_normal", effects.commonLanguageEffectSize},
      {"bf10_jzs_student", analysis::jzsBayesFactor(student, a.size(), b.size()).bf10}};
  if (effects.cohenD.value) quantities["hedges_J"] = effects.hedgesJ;
  addInterval(quantities, "cohen_d_ci95", effects.cohenD.interval);
  addInterval(quantities, "hedges_g_ci95", effects.hedgesG.interval);
  return quantities;
}

TEST(GoldenEffects, OfTwoSamplesMatchTheReference) {
  tests::WorstDigits worst("effect sizes and Bayes factors");
  int visited = 0;
  const auto all = tests::statsJson("golden.json")["two"];
  for (const auto& [dataSet, golden] : all.items()) {
    const auto groups = tests::statsGroups(dataSet);
    const auto ours = effectsOf(groups.group1.values, groups.group2.values);
    tests::compareWithGolden(dataSet, golden, ours, gateOf, worst);
    ++visited;
  }
  EXPECT_EQ(visited, 15);
  EXPECT_EQ(worst.count(), 14 * 12);  // t07 is constant in both groups
}

TEST(GoldenEffects, GiveAReasonForMissingValues) {
  const auto reasonOf = [](const std::string& dataSet) {
    const auto groups = tests::statsGroups(dataSet);
    return analysis::effectSizes(groups.group1.values, groups.group2.values).reason;
  };
  EXPECT_EQ(reasonOf("t01_likert36").key(), "");
  EXPECT_EQ(reasonOf("t10_all_ties_balanced").key(), "");
  EXPECT_EQ(reasonOf("t15_tiny_1e-200").key(), "");
  EXPECT_NE(reasonOf("t06_zero_var_one").key(), "");  // Glass's delta by group 1
  EXPECT_NE(reasonOf("t07_zero_var_both_diff").key(), "");
}

TEST(GoldenEquivalence, OfTwoSamplesMatchesTheReference) {
  tests::WorstDigits worst("equivalence");
  int visited = 0;
  const auto all = tests::statsJson("golden.json")["two"];
  for (const auto& [dataSet, golden] : all.items()) {
    const auto groups = tests::statsGroups(dataSet);
    const auto result = analysis::equivalenceTest(
        analysis::welchTTest(groups.group1.values, groups.group2.values), kHalfAPoint);
    ++visited;
    if (dataSet == "t07_zero_var_both_diff") {
      EXPECT_FALSE(result.p.has_value());
      EXPECT_FALSE(result.reason.empty());
      continue;
    }
    const auto truth = std::strtold(golden["tost05_p"].get<std::string>().c_str(), nullptr);
    EXPECT_NEAR(result.log10P.value(), static_cast<double>(std::log10(truth)), 1e-9) << dataSet;
    if (truth < 1e-300L) continue;  // t12 and t15: only the logarithm is held
    const Quantities ours{
        {"tost05_p_lower", result.aboveLower.value().p},
        {"tost05_p_upper", result.belowUpper.value().p},
        {"tost05_p", result.p}};
    tests::compareWithGolden(
        dataSet, golden, ours, [](const auto&) { return 12.0; }, worst);
  }
  EXPECT_EQ(visited, 15);
  EXPECT_EQ(worst.count(), 12 * 3);
}

Quantities pairedQuantities(const std::vector<double>& x, const std::vector<double>& y) {
  const auto test = analysis::pairedTTest(x, y);
  const auto effects = analysis::effectSizes(test);
  Quantities quantities{
      {"n", static_cast<double>(test.n)},
      {"mean_diff", test.meanDifference},
      {"var_diff", test.variance},
      {"t_paired", test.t},
      {"df_paired", test.degreesOfFreedom},
      {"p_paired", test.p},
      {"cohen_dz", effects.cohenDz.value},
      {"hedges_gz", effects.hedgesGz.value},
      {"bf10_jzs_paired", analysis::jzsBayesFactor(test).bf10}};
  addInterval(quantities, "ci95_paired", confidenceInterval(test, 0.95));
  addInterval(quantities, "cibonf3_paired", confidenceInterval(test, 1.0 - 0.05 / 3.0));
  if (test.n > 2) addInterval(quantities, "cohen_dz_ci95", effects.cohenDz.interval);
  return quantities;
}

TEST(GoldenPairs, MatchTheReferenceWithinTheirTolerance) {
  tests::WorstDigits worst("pairs");
  const auto gate = [](const std::string& quantity) {
    return quantity.starts_with("ci") ? 12.0 : gateOf(quantity);
  };
  int visited = 0;
  const auto all = tests::statsJson("golden.json")["pair"];
  for (const auto& [dataSet, golden] : all.items()) {
    const auto table = tests::statsTable("pair/" + dataSet + ".csv");
    std::vector<double> x;
    std::vector<double> y;
    for (const auto& row : table.rows) {
      x.push_back(base::decimalNumber(row.cells[table.columnIndex("x")]).value());
      y.push_back(base::decimalNumber(row.cells[table.columnIndex("y")]).value());
    }
    const auto ours = pairedQuantities(x, y);
    tests::compareWithGolden(dataSet, golden, ours, gate, worst);
    EXPECT_EQ(analysis::pairedTTest(x, y).reason.empty(), ours.at("p_paired").has_value());
    ++visited;
  }
  EXPECT_EQ(visited, 7);
  // 15 quantities of 7 sets; p06 has n, mean and variance only, p08 no g_z and no limits of d_z
  EXPECT_EQ(worst.count(), 7 * 15 - 12 - 3);
}

}  // namespace golden_means_test
