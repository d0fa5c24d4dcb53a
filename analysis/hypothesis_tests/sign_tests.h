#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "analysis/data/reason.h"

namespace analysis {

/// The result of the sign test. If a number is missing, `reason` says why.
struct SignTestResult {
  std::uint64_t positive = 0;
  std::uint64_t negative = 0;
  std::uint64_t zeros = 0;
  std::optional<double> p;         ///< exact, two-sided
  std::optional<double> log10P;    ///< defined even if p is too small for a double
  std::optional<double> pLess;     ///< exact, one-sided: P(at most as many positive differences)
  std::optional<double> pGreater;  ///< exact, one-sided: P(at least as many positive differences)
  Reason reason;                   ///< why something above is missing; empty if nothing is
};

/// The sign test (Arbuthnott 1710): are there more positive than negative differences? Zeros are
/// dropped; under the null hypothesis the signs are tosses of a fair coin: p = min(1, 2 min(P(≤ k),
/// P(≥ k))).
///
/// @throws std::invalid_argument  if a difference is NaN.
SignTestResult signTest(std::span<const double> differences);
SignTestResult signTest(std::uint64_t positive, std::uint64_t negative, std::uint64_t zeros = 0);

/// The treatment of differences of zero, which have no sign.
enum class ZeroTreatment {
  Dropped,           ///< dropped before ranking, as Wilcoxon does
  RankedThenDropped  ///< dropped after ranking, as Pratt (1959) does: zeros take the lowest ranks
};

/// The result of the Wilcoxon signed rank test. An undefined number is std::nullopt, and `reason`
/// says why.
struct SignedRankResult {
  std::uint64_t n = 0;  ///< number of all differences
  std::uint64_t positive = 0;
  std::uint64_t negative = 0;
  std::uint64_t zeros = 0;

  std::optional<double> v;             ///< sum of the ranks of the positive differences
  std::optional<double> rankBiserial;  ///< (2V − T) / T, T the sum of all ranks that have a sign

  std::optional<double> p;      ///< exact, two-sided: 2 min(P(≤ V), P(≥ V)), at most 1
  std::optional<double> pLess;  ///< exact, one-sided: P(≤ V); alternative: negative differences
  std::optional<double> pGreater;  ///< exact, one-sided: P(≥ V); alternative: positive differences

  std::optional<double> z;                      ///< normal, without continuity correction
  std::optional<double> pAsymptotic;            ///< two-sided, of z
  std::optional<double> pAsymptoticContinuity;  ///< with V moved by ½ towards its mean

  Reason reason;  ///< why something above is missing; empty if nothing is
};

/// Wilcoxon's signed rank test (1945): are paired differences symmetric about zero?
///
///     V = Σ rank |dᵢ| over dᵢ > 0,   equal |dᵢ| sharing their midrank
///
/// The exact distribution uses the midranks of the data, ties and zeros included, with all 2ⁿ
/// choices of signs equally likely. It is computed by dynamic programming over doubled ranks
/// (WeightedBernoulliSum), for up to about 300 differences. The asymptotic distribution has mean
/// Σr/2 and variance Σr²/4, over the ranks r of differences that are not zero.
///
/// Ranks depend on the last digit: pass differences of means through withoutRoundingNoise() first,
/// so that rounding errors do not break ties.
///
/// @param differences  one per pair, x − y.
/// @throws std::invalid_argument  if a difference is infinite or NaN.
SignedRankResult signedRankTest(
    std::span<const double> differences, ZeroTreatment zeros = ZeroTreatment::Dropped);

/// The result of the sign-flip test. If a number is missing, `reason` says why.
struct SignFlipResult {
  std::uint64_t n = 0;
  std::optional<double> p;         ///< exact, two-sided
  std::optional<double> pLess;     ///< exact, one-sided: P(Σ ≤ observed)
  std::optional<double> pGreater;  ///< exact, one-sided: P(Σ ≥ observed)
  Reason reason;                   ///< why p is missing; empty if p is defined
};

/// The permutation test of paired differences (Fisher 1935): if the sign of every difference were
/// random, how probable would a sum at least as far from zero as the observed one be?
///
///     p = #{ s ∈ {−1, 1}ᴺ : |Σ sᵢ dᵢ| ≥ |Σ dᵢ| } / 2ᴺ
///
/// Sums are compared as whole numbers, so that equal sums are recognised. Differences that are, up
/// to rounding, multiples of a common unit (commonUnitOf()) are replaced by these multiples, and
/// sums are counted by dynamic programming. Other differences are used as exact doubles; at most 40
/// of them may differ from zero.
///
/// @throws std::invalid_argument  if a difference is infinite or NaN.
SignFlipResult signFlipTest(std::span<const double> differences);

}  // namespace analysis
