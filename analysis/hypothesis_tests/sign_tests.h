#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "analysis/data/reason.h"

namespace analysis {

/// What the sign test says about paired differences; what is missing has its reason.
struct SignTestResult {
  std::uint64_t positive = 0;
  std::uint64_t negative = 0;
  std::uint64_t zeros = 0;
  std::optional<double> p;         ///< exact, two-sided
  std::optional<double> log10P;    ///< also where p is too small for a double
  std::optional<double> pLess;     ///< exact P(no more positive ones)
  std::optional<double> pGreater;  ///< exact P(no fewer positive ones)
  Reason reason;                   ///< why something above is missing; empty if nothing is
};

/// The sign test (Arbuthnott 1710): are there more differences up than down? Zeros are dropped, and
/// the others are tosses of a fair coin: p = min(1, 2 min(P(≤ k), P(≥ k))).
///
/// @throws std::invalid_argument  if a difference is NaN.
SignTestResult signTest(std::span<const double> differences);
SignTestResult signTest(std::uint64_t positive, std::uint64_t negative, std::uint64_t zeros = 0);

/// The treatment of differences of zero, which have no sign.
enum class Zeros {
  Dropped,           ///< before ranking, as Wilcoxon does
  RankedThenDropped  ///< after ranking, as Pratt (1959) does: zeros push the others up
};

/// What the signed rank test says about paired differences. What is not defined is
/// missing, with a reason.
struct SignedRankResult {
  std::uint64_t n = 0;  ///< all differences
  std::uint64_t positive = 0;
  std::uint64_t negative = 0;
  std::uint64_t zeros = 0;

  std::optional<double> v;             ///< sum of the ranks of the positive differences
  std::optional<double> rankBiserial;  ///< (2V − T) / T, T the sum of all ranks that have a sign

  std::optional<double> p;      ///< exact, two-sided: 2 min(P(≤ V), P(≥ V)), at most 1
  std::optional<double> pLess;  ///< exact P(≤ V): if only negative differences were of interest
  std::optional<double> pGreater;  ///< exact P(≥ V)

  std::optional<double> z;                      ///< normal, without continuity correction
  std::optional<double> pAsymptotic;            ///< two-sided, of z
  std::optional<double> log10PAsymptotic;       ///< also where p is too small for a double
  std::optional<double> pAsymptoticContinuity;  ///< with V moved by ½ towards its mean

  Reason reason;  ///< why something above is missing; empty if nothing is
};

/// Wilcoxon's signed rank test (1945): are paired differences as likely up as down?
///
///     V = Σ rank |dᵢ| over dᵢ > 0,   equal |dᵢ| sharing their midrank
///
/// The exact law is that of the given midranks under all 2ⁿ choices of signs, ties and zeros
/// included, by dynamic programming over doubled ranks (SubsetSums): for some 300 differences.
/// The asymptotic one has mean Σr/2 and variance Σr²/4, over the ranks r that have a sign.
///
/// Ranks depend on the last digit. Differences of means that would be equal but for rounding want
/// withoutRoundingNoise() first.
///
/// @param differences  one per pair, x − y.
/// @throws std::invalid_argument  if a difference is infinite or NaN.
SignedRankResult signedRankTest(std::span<const double> differences, Zeros zeros = Zeros::Dropped);

/// What the sign-flip test says about paired differences; what is missing has its reason.
struct SignFlipResult {
  std::uint64_t n = 0;
  std::optional<double> p;         ///< exact, two-sided
  std::optional<double> pLess;     ///< exact P(Σ ≤ observed)
  std::optional<double> pGreater;  ///< exact P(Σ ≥ observed)
  Reason reason;                   ///< why p is missing; empty if it is not
};

/// The permutation test of paired differences (Fisher 1935): had every difference its sign by the
/// toss of a coin, how probable would a sum be as far from zero as this one?
///
///     p = #{ s ∈ {−1, 1}ᴺ : |Σ sᵢ dᵢ| ≥ |Σ dᵢ| } / 2ᴺ
///
/// Sums are compared as whole numbers, so that ties are ties: differences that are multiples of a
/// common unit but for rounding (commonUnitOf()) as those multiples, by dynamic programming over
/// sums; others exactly as the doubles that they are, for at most 40 that are not zero.
///
/// @throws std::invalid_argument  if a difference is infinite or NaN.
SignFlipResult signFlipTest(std::span<const double> differences);

}  // namespace analysis
