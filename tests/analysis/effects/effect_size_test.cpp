#include "analysis/effects/effect_size.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace effect_size_test {

using analysis::effectSizes;
using analysis::hedgesCorrection;
using Values = std::vector<double>;

TEST(HedgesCorrection, IsExact) {
  // Γ(1)/Γ(1/2) = 1/√π; Γ(3/2)/(√(3/2) Γ(1)) = √(π/6); Γ(2)/(√2 Γ(3/2)) = √(2/π)
  EXPECT_NEAR(hedgesCorrection(2.0).value(), std::numbers::inv_sqrtpi, 1e-15);
  EXPECT_NEAR(hedgesCorrection(3.0).value(), std::sqrt(std::numbers::pi / 6.0), 1e-15);
  EXPECT_NEAR(hedgesCorrection(4.0).value(), std::sqrt(2.0 / std::numbers::pi), 1e-15);
}

TEST(HedgesCorrection, TendsToOneAsItsApproximationDoes) {
  for (const double many : {1e3, 1e5, 1e8}) {
    EXPECT_NEAR(
        hedgesCorrection(many).value(), 1.0 - 3.0 / (4.0 * many - 1.0), 1.0 / (many * many));
  }
}

TEST(HedgesCorrection, IsUndefinedForOneDegreeOfFreedom) {
  EXPECT_FALSE(hedgesCorrection(1.0).has_value());
  EXPECT_FALSE(hedgesCorrection(NAN).has_value());
}

TEST(EffectSizes, FollowFromTheirDefinition) {
  // means 4 and 2, variances 1 and 4, three values each: pooled variance 2.5
  const auto effects = effectSizes(Values{3.0, 4.0, 5.0}, Values{0.0, 2.0, 4.0});

  EXPECT_DOUBLE_EQ(effects.cohenD.value.value(), 2.0 / std::sqrt(2.5));
  EXPECT_DOUBLE_EQ(effects.cohenDAv.value.value(), 2.0 / std::sqrt(2.5));
  EXPECT_DOUBLE_EQ(effects.glassDelta1.value(), 2.0);
  EXPECT_DOUBLE_EQ(effects.glassDelta2.value(), 1.0);
  EXPECT_DOUBLE_EQ(
      effects.hedgesG.value.value(), 2.0 / std::sqrt(2.5) * std::sqrt(2.0 / std::numbers::pi));
  // Φ(2/√5): R: pnorm(2 / sqrt(5))
  EXPECT_NEAR(effects.commonLanguageEffectSize.value(), 0.81445331, 1e-8);
  EXPECT_TRUE(effects.reason.empty());
}

TEST(EffectSizes, HaveTheSameIntervalByBothTestsForEqualSizesAndVariances) {
  const auto effects = effectSizes(Values{1.0, 2.0, 3.0, 4.0}, Values{3.0, 4.0, 5.0, 6.0});

  EXPECT_NEAR(effects.cohenD.interval->low, effects.cohenDAv.interval->low, 1e-13);
  EXPECT_NEAR(effects.cohenD.interval->high, effects.cohenDAv.interval->high, 1e-13);
  EXPECT_NEAR(effects.hedgesG.interval->high, effects.hedgesGAv.interval->high, 1e-13);
}

TEST(EffectSizes, HaveWiderIntervalsForMoreConfidence) {
  const Values a{1.0, 2.0, 3.0, 4.0};
  const Values b{3.0, 4.0, 5.0, 7.0};
  const auto usual = effectSizes(a, b);
  const auto wide = effectSizes(a, b, 0.99);

  EXPECT_EQ(wide.level, 0.99);
  EXPECT_LT(wide.cohenD.interval->low, usual.cohenD.interval->low);
  EXPECT_GT(wide.cohenD.interval->high, usual.cohenD.interval->high);
  EXPECT_LT(usual.cohenD.interval->low, usual.cohenD.value.value());
}

TEST(EffectSizes, GiveAReasonForMissingValues) {
  const auto oneConstant = effectSizes(Values{5.0, 5.0, 5.0}, Values{1.0, 2.0, 4.0});
  EXPECT_TRUE(oneConstant.cohenD.value.has_value());
  EXPECT_FALSE(oneConstant.glassDelta1.has_value());
  EXPECT_TRUE(oneConstant.glassDelta2.has_value());
  EXPECT_EQ(oneConstant.reason.key(), "a_group_is_constant");

  const auto constant = effectSizes(Values{5.0, 5.0}, Values{1.0, 1.0});
  EXPECT_FALSE(constant.cohenD.value.has_value());
  EXPECT_FALSE(constant.cohenD.interval.has_value());
  EXPECT_FALSE(constant.commonLanguageEffectSize.has_value());
  EXPECT_FALSE(constant.reason.empty());

  const auto single = effectSizes(Values{5.0}, Values{1.0, 2.0, 4.0});
  EXPECT_TRUE(single.cohenD.value.has_value());  // by the other group's spread
  EXPECT_FALSE(single.cohenDAv.value.has_value());
  EXPECT_FALSE(single.reason.empty());

  EXPECT_FALSE(effectSizes(Values{}, Values{}).reason.empty());
}

TEST(EffectSizes, HaveIntervalsForVeryLargeEffects) {
  // x − 0 of about 1e30 standard errors: the limits are t times the roots of χ²/ν, ν = 2
  const auto far = effectSizes(Values{1e15, 1e15}, Values{0.0, 1e-15});
  const double d = far.cohenD.value.value();
  EXPECT_NEAR(far.cohenD.interval->low / d, std::sqrt(-std::log(1.0 - 0.025)), 1e-12);
  EXPECT_NEAR(far.cohenD.interval->high / d, std::sqrt(-std::log(0.025)), 1e-12);

  const auto farthest = effectSizes(Values{1e150, 1e150}, Values{0.0, 1e-15});
  EXPECT_TRUE(farthest.cohenD.value.has_value());
  EXPECT_FALSE(farthest.cohenD.interval.has_value());
  EXPECT_FALSE(farthest.reason.empty());
}

TEST(EffectSizes, RejectInvalidConfidenceLevels) {
  EXPECT_THROW(effectSizes(Values{}, Values{}, 1.0), std::invalid_argument);
}

TEST(PairedEffects, AreStandardisedByTheDifferences) {
  // differences 1, 2, 4: mean 7/3, variance 7/3
  const auto test = analysis::pairedTTest(Values{1.0, 2.0, 4.0}, Values{0.0, 0.0, 0.0});
  const auto effects = effectSizes(test);

  EXPECT_NEAR(effects.cohenDz.value.value(), std::sqrt(7.0 / 3.0), 1e-15);
  EXPECT_NEAR(effects.hedgesJ.value(), std::numbers::inv_sqrtpi, 1e-15);
  EXPECT_LT(effects.cohenDz.interval->low, effects.cohenDz.value.value());
  EXPECT_DOUBLE_EQ(
      effects.hedgesGz.interval->high, effects.cohenDz.interval->high * *effects.hedgesJ);
}

TEST(PairedEffects, GiveAReasonForMissingValues) {
  const auto two = effectSizes(analysis::pairedTTest(Values{5.0, 4.0}, Values{2.0, 3.0}));
  EXPECT_TRUE(two.cohenDz.interval.has_value());
  EXPECT_FALSE(two.hedgesGz.value.has_value());
  EXPECT_EQ(two.reason.key(), "two_pairs_only");

  const auto constant = effectSizes(analysis::pairedTTest(Values{5.0, 4.0}, Values{4.0, 3.0}));
  EXPECT_FALSE(constant.cohenDz.value.has_value());
  EXPECT_FALSE(constant.reason.empty());
}

}  // namespace effect_size_test
