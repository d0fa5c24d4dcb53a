// The golden values of rank tests and votes in tests/data/stats, to the gates of the README there:
// every quantity of these tests in every data set.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/data/csv_table.h"
#include "analysis/data/vote_shares.h"
#include "analysis/effects/effect_size.h"
#include "analysis/hypothesis_tests/friedman.h"
#include "analysis/hypothesis_tests/rank_tests.h"
#include "analysis/hypothesis_tests/sign_tests.h"
#include "analysis/hypothesis_tests/vote_tests.h"
#include "tests/analysis/golden_check.h"
#include "tests/analysis/golden_file.h"
#include "tests/support/test_data.h"

namespace golden_ranks_test {

using tests::Quantities;

double gateOf(const std::string& quantity) {
  if (quantity.starts_with("nemenyi")) return 9.0;
  const bool isOfALaw = quantity.find("asym") != std::string::npos || quantity.ends_with("_p") ||
                        quantity.find("95") != std::string::npos;
  return isOfALaw ? 12.0 : 14.0;
}

/// Compares what both have. @param prefixes  of the quantities in the golden file that must all be
/// ours.
void compare(
    const std::string& dataSet,
    const nlohmann::json& golden,
    Quantities ours,
    const std::vector<std::string>& prefixes,
    tests::WorstDigits& worst) {
  for (const auto& entry : golden.items()) {
    const auto begins = [&](const std::string& prefix) { return entry.key().starts_with(prefix); };
    if (std::ranges::none_of(prefixes, begins)) continue;
    ASSERT_TRUE(ours.contains(entry.key())) << dataSet << " " << entry.key();
  }
  std::erase_if(ours, [&](const auto& quantity) { return !golden.contains(quantity.first); });
  tests::compareWithGolden(dataSet, golden, ours, gateOf, worst);
}

std::vector<std::vector<double>> rowsOf(const std::string& file, std::size_t firstColumn) {
  std::vector<std::vector<double>> rows;
  for (const auto& row : tests::statsTable(file).rows) {
    std::vector<double> numbers;
    for (std::size_t i = firstColumn; i < row.cells.size(); ++i) {
      numbers.push_back(base::decimalNumber(row.cells[i]).value());
    }
    rows.push_back(numbers);
  }
  return rows;
}

void addSignedRank(Quantities& quantities, const std::string& name, const std::vector<double>& d) {
  const auto result = analysis::signedRankTest(
      d,
      name == "wilcox" ? analysis::ZeroTreatment::Dropped
                       : analysis::ZeroTreatment::RankedThenDropped);
  quantities[name + "_V"] = result.v;
  quantities[name + "_p_exact"] = result.p;
  quantities[name + "_p_asym_cc"] = result.pAsymptoticContinuity;
  quantities[name + "_p_asym_nocc"] = result.pAsymptotic;
  quantities[name + "_rank_biserial"] = result.rankBiserial;
}

TEST(GoldenPairs, MatchTheReferenceWithinTheirTolerance) {
  const auto golden = tests::statsJson("golden.json")["pair"];
  tests::WorstDigits worst("signed ranks");
  for (const auto& [dataSet, truth] : golden.items()) {
    std::vector<double> differences;
    for (const auto& row : rowsOf("pair/" + dataSet + ".csv", 0)) {
      differences.push_back(row.at(0) - row.at(1));
    }
    const auto sign = analysis::signTest(differences);
    Quantities quantities{
        {"p_sign", sign.p},
        {"n_pos", static_cast<double>(sign.positive)},
        {"n_neg", static_cast<double>(sign.negative)},
        {"n_zero", static_cast<double>(sign.zeros)}};
    addSignedRank(quantities, "wilcox", differences);
    addSignedRank(quantities, "pratt", differences);
    compare(dataSet, truth, quantities, {"p_sign", "n_", "wilcox_", "pratt_"}, worst);
  }
  EXPECT_EQ(worst.count(), 7 * (4 + 2 * 5));
}

Quantities rankQuantities(const std::vector<double>& a, const std::vector<double>& b) {
  const auto mannWhitney = analysis::mannWhitneyTest(a, b);
  const auto brunnerMunzel = analysis::brunnerMunzelTest(a, b);
  const auto cliff = analysis::cliffDelta(a, b);
  Quantities quantities{
      {"mwu_U", mannWhitney.u},
      {"mwu_var", mannWhitney.variance},
      {"mwu_p_asym_nocc", mannWhitney.pAsymptotic},
      {"mwu_p_asym_cc", mannWhitney.pAsymptoticContinuity},
      {"mwu_p_exact_double", mannWhitney.p},
      {"mwu_p_exact_less", mannWhitney.pLess},
      {"mwu_p_exact_greater", mannWhitney.pGreater},
      {"bm_W", brunnerMunzel.w},
      {"bm_df", brunnerMunzel.degreesOfFreedom},
      {"bm_p", brunnerMunzel.p},
      {"cliff_delta", cliff.delta},
      {"cliff_var_unbiased", cliff.variance}};
  if (cliff.interval) {
    quantities["cliff_ci95_lo"] = cliff.interval->low;
    quantities["cliff_ci95_hi"] = cliff.interval->high;
  }
  return quantities;
}

TEST(GoldenRankSums, MatchTheReferenceWithinTheirTolerance) {
  const auto golden = tests::statsJson("golden.json")["two"];
  tests::WorstDigits worst("rank sums");
  for (const auto& [dataSet, truth] : golden.items()) {
    const auto groups = tests::statsGroups(dataSet);
    const auto ours = rankQuantities(groups.group1.values, groups.group2.values);
    auto expected = truth;
    expected.erase("mwu_p_exact_abs");  // P(U at least as far from its mean): not computed
    compare(dataSet, expected, ours, {"mwu_", "bm_", "cliff_"}, worst);
    EXPECT_EQ(ours.contains("cliff_ci95_lo"), truth.contains("cliff_ci95_lo")) << dataSet;
  }
  // 15 sets × (4 + 3 exact + 3 + 2 + 2), less what t12 and t17 are too large for, and what the four
  // sets without overlap leave undefined: W, df, p and an interval.
  EXPECT_EQ(worst.count(), 15 * 14 - 2 * 3 - 4 * 5);
}

TEST(GoldenBlocks, MatchTheReferenceWithinTheirTolerance) {
  const auto golden = tests::statsJson("golden.json")["block"];
  tests::WorstDigits worst("Friedman");
  int pairs = 0;
  for (const auto& [dataSet, truth] : golden.items()) {
    const std::string file = "block/" + dataSet + ".csv";
    const auto columns = tests::statsTable(file).columns;
    const auto result = analysis::friedmanTest(rowsOf(file, 1));
    Quantities quantities{
        {"friedman_chi2", result.chiSquared},
        {"friedman_df", static_cast<double>(result.treatments - 1)},
        {"friedman_p", result.p},
        {"friedman_p_exact_permutation", result.exactP},
        {"kendall_W", result.kendallW},
        {"iman_davenport_F", result.imanDavenportF},
        {"iman_davenport_p", result.imanDavenportP}};
    for (const auto& pair : result.pairs) {
      quantities["nemenyi_p_" + columns.at(pair.first + 1) + "_" + columns.at(pair.second + 1)] =
          pair.nemenyiP;
      ++pairs;
    }
    compare(dataSet, truth, quantities, {"friedman_", "kendall_", "iman_", "nemenyi_"}, worst);
  }
  EXPECT_EQ(pairs, 3 + 3 + 3 + 6);
  EXPECT_EQ(worst.count(), 4 * 6 + 3 - 1 + pairs);  // three exact p; one F is infinite
}

TEST(GoldenVotes, MatchTheReferenceWithinTheirTolerance) {
  const auto golden = tests::statsJson("golden.json")["counts"];
  tests::WorstDigits worst("votes and their intervals");
  const auto all = tests::statsJson("counts.json");
  for (const auto& entry : all.items()) {
    analysis::VoteCounts votes({"I", "F", "K"});
    for (const auto& [option, count] : entry.value().items()) {
      votes.add(option, count.get<unsigned>());
    }
    const auto result = analysis::equalSharesTest(votes);
    Quantities quantities{
        {"n", static_cast<double>(result.votes)},
        {"p_multinomial_exact", result.exactP},
        {"chi2", result.chiSquared},
        {"chi2_p", result.p}};
    for (const auto& share : votes.shares()) {
      const auto wilson = analysis::wilsonInterval(share.votes, votes.total()).value();
      const auto exact = analysis::clopperPearsonInterval(share.votes, votes.total()).value();
      quantities[share.option + "_share"] = share.share;
      quantities[share.option + "_wilson95_lo"] = wilson.low;
      quantities[share.option + "_wilson95_hi"] = wilson.high;
      quantities[share.option + "_cp95_lo"] = exact.low;
      quantities[share.option + "_cp95_hi"] = exact.high;
    }
    compare(entry.key(), golden[entry.key()], quantities, {""}, worst);
  }
  EXPECT_EQ(worst.count(), 4 * (4 + 3 * 5));
}

}  // namespace golden_ranks_test
