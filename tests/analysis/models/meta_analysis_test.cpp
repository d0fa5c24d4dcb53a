#include "analysis/models/meta_analysis.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/analysis/digits.h"
#include "tests/analysis/golden_file.h"

namespace meta_analysis_test {

using analysis::EstimateWithError;
using analysis::PooledEstimate;
using nlohmann::json;

/// Every number that is not exactly zero agrees to this many digits: metafor's scoring stops some
/// 1e-13 beside the maximum.
constexpr double kDigits = 10.0;

void expectSame(double number, const json& truth, const std::string& what) {
  constexpr double kAsGoodAsZero = 1e-12;  // where metafor's scoring creeps towards zero
  const double about = std::stod(truth.get<std::string>());
  if (std::abs(number) < kAsGoodAsZero && std::abs(about) < kAsGoodAsZero) return;
  EXPECT_GE(tests::correctDigits(number, truth.get<std::string>()), kDigits)
      << what << ": " << number << " and not " << truth;
}

void expectSame(const PooledEstimate& pooled, const json& truth, const std::string& what) {
  expectSame(pooled.estimate, truth["estimate"], what + " estimate");
  expectSame(pooled.standardError, truth["se"], what + " se");
  expectSame(pooled.interval.low, truth["low"], what + " low");
  expectSame(pooled.interval.high, truth["high"], what + " high");
  expectSame(pooled.statistic, truth["statistic"], what + " statistic");
  expectSame(pooled.p, truth["p"], what + " p");
  expectSame(pooled.tauSquared, truth["tau2"], what + " tau2");
  expectSame(100.0 * pooled.iSquared, truth["i2"], what + " i2");
}

std::vector<EstimateWithError> sitesOf(const json& set) {
  std::vector<EstimateWithError> sites;
  for (std::size_t i = 0; i < set["y"].size(); ++i) {
    sites.push_back({set["y"][i].get<double>(), set["se"][i].get<double>()});
  }
  return sites;
}

TEST(MetaAnalysis, AgreesWithMetafor) {
  const auto golden = tests::statsJson("sites/golden.json");
  ASSERT_EQ(golden.size(), 7U);
  for (const auto& [name, set] : golden.items()) {
    const auto sites = sitesOf(set);
    const auto all = analysis::pooled(sites, 0.95);
    EXPECT_EQ(all.sites, sites.size());
    expectSame(all.q, set["q"], name + " Q");
    expectSame(all.heterogeneityP, set["q_p"], name + " p of Q");
    expectSame(all.common, set["common"], name + " common");
    expectSame(all.derSimonianLaird, set["dl"], name + " DL");
    expectSame(all.reml, set["reml"], name + " REML");
    expectSame(all.knappHartung, set["reml_knapp_hartung"], name + " Knapp-Hartung");
    const auto without = analysis::leaveOneOut(sites, 0.95);
    ASSERT_EQ(without.size(), set["without"].size()) << name;
    for (std::size_t i = 0; i < without.size(); ++i) {
      expectSame(without[i], set["without"][i], name + " without " + std::to_string(i));
    }
  }
}

TEST(MetaAnalysis, IsTheSameToFourDigitsIfQuick) {
  const auto golden = tests::statsJson("sites/golden.json");
  for (const auto& [name, set] : golden.items()) {
    const auto sites = sitesOf(set);
    const auto exact = analysis::pooled(sites, 0.95).knappHartung;
    const auto quick = analysis::pooledToFourDigits(sites, 0.95);
    EXPECT_NEAR(quick.estimate, exact.estimate, 1e-4 * exact.standardError) << name;
    EXPECT_NEAR(quick.standardError, exact.standardError, 1e-4 * exact.standardError) << name;
    EXPECT_NEAR(quick.p, exact.p, 1e-4) << name;
  }
}

TEST(MetaAnalysis, TakesSitesOfVeryDifferentPrecision) {
  const std::vector<EstimateWithError> sites{{0.5, 1e-9}, {0.2, 1e9}, {0.7, 1.0}};
  const auto all = analysis::pooled(sites, 0.95);
  EXPECT_NEAR(all.reml.estimate, 0.5, 0.2);
  for (const auto& one : {all.common, all.derSimonianLaird, all.reml, all.knappHartung}) {
    EXPECT_TRUE(std::isfinite(one.estimate) && one.standardError > 0.0 && one.p >= 0.0);
    EXPECT_TRUE(one.iSquared >= 0.0 && one.iSquared <= 1.0);
  }
}

TEST(MetaAnalysis, RefusesWhatCannotBePooled) {
  const std::vector<EstimateWithError> one{{0.5, 0.1}};
  const std::vector<EstimateWithError> exact{{0.5, 0.1}, {0.2, 0.0}};
  EXPECT_THROW(analysis::pooled(one, 0.95), std::invalid_argument);
  EXPECT_THROW(analysis::pooled(exact, 0.95), std::invalid_argument);
}

}  // namespace meta_analysis_test
