#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/data/reason.h"

namespace analysis {

/// The exact p of Friedman's test: the probability of rank sums at least as unequal as these, if
/// all permutations of the ranks of a block are equally likely.
///
/// Counted in whole numbers by dynamic programming over the rank sums of all but one treatment.
/// std::nullopt without blocks, or with too many: without ties, from 127 blocks of two treatments,
/// 49 of three, 11 of four, 3 of five.
///
/// @param doubledRanks  a row per block, of as many doubled midranks as there are treatments.
std::optional<double> friedmanPermutationP(
    std::span<const std::vector<std::uint64_t>> doubledRanks);

/// One pair of treatments, compared by their mean ranks.
struct RankComparison {
  std::size_t first = 0;  ///< index of the treatment
  std::size_t second = 0;
  double meanRankDifference = 0.0;  ///< mean rank of the first − mean rank of the second

  double nemenyiQ = 0.0;  ///< |difference| / √(k(k + 1)/(6b)) · √2
  /// From the studentized range of k normal values: already adjusted for all pairs.
  double nemenyiP = 1.0;
  double nemenyiLog10P = 0.0;  ///< defined even if p is too small for a double

  std::optional<double> conoverT;  ///< signed as the difference; std::nullopt if all blocks agree
  /// (b − 1)(k − 1)
  std::optional<double> conoverDegreesOfFreedom;
  std::optional<double> conoverP;  ///< two-sided, not yet corrected for the number of pairs
};

/// The result of Friedman's test. An undefined number is std::nullopt, and `reason` says why.
struct FriedmanResult {
  std::uint64_t blocks = 0;      ///< b: participants
  std::uint64_t treatments = 0;  ///< k

  std::optional<double> chiSquared;  ///< corrected for ties; k − 1 degrees of freedom
  std::optional<double> p;           ///< of χ²
  std::optional<double> log10P;      ///< defined even if p is too small for a double
  std::optional<double> kendallW;    ///< 0 … 1: agreement of the blocks

  std::optional<double> imanDavenportF;  ///< +infinity if all blocks agree
  std::optional<double> imanDavenportP;  ///< of F with k − 1 and (k − 1)(b − 1); 0 if F is infinite

  std::optional<double> exactP;  ///< over all permutations of the midranks within blocks

  std::vector<RankComparison> pairs;  ///< empty if the test is not defined
  Reason reason;                      ///< why something above is missing; empty if nothing is
};

/// Friedman's test (1937): do treatments differ, if every block ranks them? With Rⱼ the rank sums
/// and t the sizes of ties within blocks,
///
///     Q = 12 Σ(Rⱼ − b(k + 1)/2)² / (b k (k + 1) − Σ(t³ − t)/(k − 1)),   W = Q / (b (k − 1))
///     F = (b − 1) Q / (b (k − 1) − Q)                                      (Iman & Davenport 1980)
///     t = (Rᵢ − Rⱼ) / √(2 (b Σr² − ΣRⱼ²) / ((b − 1)(k − 1)))               (Conover 1999, § 5.8)
///
/// @param blocks  a row per block, a value per treatment.
/// @throws std::invalid_argument  for rows of unlike length, of fewer than two or more than 50
///     values, for more than a million rows, or a value that is infinite or NaN.
FriedmanResult friedmanTest(std::span<const std::vector<double>> blocks);

}  // namespace analysis
