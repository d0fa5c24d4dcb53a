#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/effects/effect_size.h"
#include "analysis/hypothesis_tests/sign_tests.h"

namespace signed_rank_test {

using analysis::hodgesLehmann;
using analysis::signedRankTest;
using analysis::signTest;
using analysis::ZeroTreatment;
using Values = std::vector<double>;

// Hollander & Wolfe 1973, p. 29: depression before − after tranquillisers (R: ?wilcox.test)
const Values kDepression{0.952, -0.147, 1.022, 0.430, 0.620, 0.590, 0.490, -0.080, 0.010};

/// By all 2ⁿ choices of signs.
double slowP(const Values& ranks, double observed) {
  double below = 0.0;
  double above = 0.0;
  const unsigned all = 1U << ranks.size();
  for (unsigned choice = 0; choice < all; ++choice) {
    double sum = 0.0;
    for (std::size_t i = 0; i < ranks.size(); ++i) sum += (choice >> i & 1U) != 0 ? ranks[i] : 0.0;
    below += sum <= observed ? 1.0 : 0.0;
    above += sum >= observed ? 1.0 : 0.0;
  }
  return std::min(1.0, 2.0 * std::min(below, above) / all);
}

TEST(SignedRankTest, HasThePublishedPOfDepressionScores) {
  const auto result = signedRankTest(kDepression);
  EXPECT_EQ(result.v, 40.0);  // R: V = 40, p-value = 0.01953 one-sided
  EXPECT_EQ(result.pGreater, 10.0 / 512.0);
  EXPECT_EQ(result.p, 20.0 / 512.0);
  EXPECT_DOUBLE_EQ(result.rankBiserial.value(), 35.0 / 45.0);
  EXPECT_EQ(result.reason.key(), "");
}

TEST(SignedRankTest, CountsTiesAsGoingThroughAllSigns) {
  const Values differences{1, 1, -1, 2, 2, -2, 3, 3, 3, -4};
  const Values midranks{2, 2, 2, 5, 5, 5, 8, 8, 8, 10};
  const auto result = signedRankTest(differences);
  EXPECT_EQ(result.v, 38.0);
  EXPECT_EQ(result.p, slowP(midranks, 38.0));
}

TEST(SignedRankTest, RanksZerosWithPrattsMethod) {
  const Values differences{0, 0, 1, -2, 3, 4};
  EXPECT_EQ(signedRankTest(differences).v, 8.0);  // ranks 1 … 4
  EXPECT_EQ(signedRankTest(differences, ZeroTreatment::RankedThenDropped).v, 14.0);  // ranks 3 … 6
  EXPECT_EQ(
      signedRankTest(differences, ZeroTreatment::RankedThenDropped).p, slowP({3, 4, 5, 6}, 14.0));
  EXPECT_EQ(signedRankTest(differences).zeros, 2U);
}

TEST(SignedRankTest, MirrorsWithTheSign) {
  Values mirrored = kDepression;
  for (double& value : mirrored) value = -value;
  const auto result = signedRankTest(kDepression);
  const auto mirror = signedRankTest(mirrored);
  EXPECT_EQ(result.p, mirror.p);
  EXPECT_EQ(result.pLess, mirror.pGreater);
  EXPECT_EQ(result.z.value(), -mirror.z.value());
  EXPECT_EQ(result.pAsymptoticContinuity, mirror.pAsymptoticContinuity);
}

TEST(SignedRankTest, GivesAReasonIfThereIsNothingToTest) {
  const auto none = signedRankTest(Values{});
  const auto zeros = signedRankTest(Values{0.0, 0.0, -0.0});
  EXPECT_EQ(none.reason.key(), "no_differences");
  EXPECT_FALSE(none.p.has_value());
  EXPECT_EQ(zeros.reason.key(), "no_sign_to_test");
  EXPECT_EQ(zeros.zeros, 3U);
  EXPECT_FALSE(zeros.v.has_value());
  EXPECT_FALSE(zeros.pAsymptotic.has_value());
}

TEST(SignedRankTest, CannotBeSignificantForOne) {
  const auto one = signedRankTest(Values{2.5});
  EXPECT_EQ(one.p, 1.0);
  EXPECT_EQ(one.pGreater, 0.5);
  EXPECT_EQ(one.reason.key(), "");
}

TEST(SignedRankTest, LeavesTheExactPOutForVeryMany) {
  Values many;
  for (int i = 1; i <= 3000; ++i) many.push_back(i);
  const auto result = signedRankTest(many);
  EXPECT_FALSE(result.p.has_value());
  EXPECT_FALSE(result.reason.empty());
  EXPECT_EQ(result.pAsymptotic, 0.0);
  // z² = 3n(n + 1)/(2(2n + 1))
  EXPECT_NEAR(result.z.value() * result.z.value(), 3.0 * 3000 * 3001 / (2.0 * 6001), 1e-9);
}

TEST(SignedRankTest, HasTheSmallestPOfTheLawAtTheLargestV) {
  Values all;
  for (int i = 1; i <= 300; ++i) all.push_back(i);
  EXPECT_EQ(signedRankTest(all).p, std::ldexp(1.0, -299));
}

TEST(SignedRankTest, RefusesValuesWithoutARank) {
  EXPECT_THROW(signedRankTest(Values{1.0, std::nan("")}), std::invalid_argument);
  EXPECT_THROW(signedRankTest(Values{1.0, HUGE_VAL}), std::invalid_argument);
}

TEST(HodgesLehmann, IsThatOfDepressionScores) {
  // Hollander & Wolfe: θ = 0.46.
  EXPECT_NEAR(hodgesLehmann(kDepression).estimate.value(), 0.46, 1e-12);
  EXPECT_EQ(hodgesLehmann(Values{1, 2, 3, 4, 6}).estimate, 3.0);
}

TEST(HodgesLehmann, IsUndefinedForNone) {
  EXPECT_EQ(hodgesLehmann(Values{}).reason.key(), "no_differences");
  EXPECT_EQ(hodgesLehmann(Values{7.0}).estimate, 7.0);
}

TEST(SignTest, IsABinomialTestOfOneHalf) {
  const auto result = signTest(9, 1, 3);
  EXPECT_EQ(result.p, 22.0 / 1024.0);  // R: binom.test(9, 10)
  EXPECT_EQ(result.pGreater, 11.0 / 1024.0);
  EXPECT_EQ(result.pLess, 1023.0 / 1024.0);
  EXPECT_EQ(signTest(5, 5).p, 1.0);
  EXPECT_EQ(signTest(5, 4).p, 1.0);
  EXPECT_EQ(signTest(1, 0).p, 1.0);
}

TEST(SignTest, CountsVeryMany) {
  const auto result = signTest(0, 2000);
  EXPECT_FALSE(result.p.has_value());
  EXPECT_NEAR(result.log10P.value(), -1999.0 * std::log10(2.0), 1e-10);
  EXPECT_FALSE(result.reason.empty());
  EXPECT_FALSE(signTest(std::uint64_t{1} << 40, 1).p.has_value());
  // 2 P(X ≤ 4900), n = 10000: .0466 is 2 Φ(−1.99), with continuity
  EXPECT_NEAR(signTest(4900, 5100).p.value(), std::erfc(1.99 / std::sqrt(2.0)), 1e-5);
}

TEST(SignTest, GivesAReasonIfThereIsNoSign) {
  EXPECT_EQ(signTest(Values{}).reason.key(), "no_differences");
  EXPECT_EQ(signTest(Values{0.0}).reason.key(), "no_sign_to_test");
  EXPECT_FALSE(signTest(Values{0.0}).p.has_value());
}

}  // namespace signed_rank_test
