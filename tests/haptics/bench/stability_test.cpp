// `palpate bench stability` in its short form: every bound holds, and a bound can be missed.
#include "haptics/bench/stability.h"

#include <gtest/gtest.h>

namespace haptics::bench {
namespace stability_test {

constexpr double kShort = 0.05;

void expectAllPassed(void (*sweep)(double, StabilityResult&), double effort = kShort) {
  StabilityResult result;
  sweep(effort, result);
  EXPECT_FALSE(result.checks.empty());
  for (const auto& check : result.checks) {
    EXPECT_TRUE(check.isPassed()) << check.sweep << ": " << check.what << " (" << check.build
                                  << ", at " << check.parameter << "): " << check.measured
                                  << ", at most " << check.bound;
  }
}

TEST(Stability, HoldsForFiniteElements) {
  expectAllPassed(sweepFiniteElements, 0.3);
}
TEST(Stability, HoldsForTheFilter) {
  expectAllPassed(sweepFilter, 0.3);
}
TEST(Stability, HoldsForSplines) {
  expectAllPassed(sweepSplines);
}
TEST(Stability, HoldsForWalls) {
  expectAllPassed(sweepWalls);
}
TEST(Stability, HoldsAtOddRates) {
  expectAllPassed(sweepRates);
}
TEST(Stability, HoldsWithBadInput) {
  expectAllPassed(sweepBadInput);
}

TEST(Stability, HoldsWithBadInputOfAnyLength) {
  // 4,000 to 20,000 ticks, so that whose turn it is in paper-text differs at their end.
  for (const double effort : {0.02, 0.021, 0.03, 0.1}) {
    StabilityResult result;
    sweepBadInput(effort, result);
    for (const auto& check : result.checks) {
      EXPECT_TRUE(check.isPassed()) << effort << ": " << check.what << ": " << check.measured;
    }
  }
}

TEST(Stability, IsTheSameEveryTime) {
  StabilityResult once;
  StabilityResult again;
  sweepSplines(kShort, once);
  sweepSplines(kShort, again);
  ASSERT_EQ(once.checks.size(), again.checks.size());
  for (std::size_t i = 0; i < once.checks.size(); ++i) {
    EXPECT_EQ(once.checks[i].measured, again.checks[i].measured);
  }
}

TEST(Stability, IsTriedInTwoKindsOfArithmetic) {
  const auto* fused = fusedKernels();
  if (fused == nullptr) GTEST_SKIP() << "this processor has no fused multiply-add";
  EXPECT_STRNE(fused->name, plainKernels().name);
  // 1 − 0.1 · 10 is rounded away in one and not in the other: the same sources, two results.
  int different = 0;
  for (int i = 1; i < 200; ++i) {
    const double a[3]{0.0, 1.0 / i, 0.1 * i};
    const double b[3]{1.0 / (i + 2), 3.0 / i, 0.7};
    double plain = 0.0;
    double other = 0.0;
    ASSERT_TRUE(plainKernels().cubic(a, b, 0.3 / (i + 2), plain));
    ASSERT_TRUE(fused->cubic(a, b, 0.3 / (i + 2), other));
    EXPECT_NEAR(plain, other, 1e-13);
    different += plain != other ? 1 : 0;
  }
  EXPECT_GT(different, 10);
}

}  // namespace stability_test
}  // namespace haptics::bench
