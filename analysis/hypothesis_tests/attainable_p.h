#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "analysis/hypothesis_tests/adjustment.h"

namespace analysis {

// The smallest exact two-sided p that any answers can give: with few participants it may be above
// the level of significance. log10P is valid also where p is too small for a double.

/// The smallest value that an exact p can have.
struct AttainableP {
  double p = 1.0;
  double log10P = 0.0;
};

/// Up to which value the smallest p of a family of tests is significant after correction.
struct FamilyLevels {
  double strictest = 0.05;    ///< for any other p values of the family
  double mostLenient = 0.05;  ///< if all p values of the family are alike
};

/// Of m tests: strictest is α / m; 1 − (1 − α)^(1/m) for HolmSidak, α / (m (1 + 1/2 + … + 1/m)) for
/// BenjaminiYekutieli. mostLenient is the same for Bonferroni, Holm and HolmSidak; m times that for
/// all others.
/// @param correction  std::nullopt: both are @p alpha
/// @throws std::invalid_argument  for an alpha that is not between 0 and 1, or no tests.
FamilyLevels levelsOf(double alpha, std::size_t tests, std::optional<Adjustment> correction);

/// Sign flips, the sign test and the signed rank test on n differences of the same sign:
///
///     p = 2 / 2ⁿ = 2^(1 − n)
///
/// 1 for fewer than two differences.
AttainableP smallestSignFlipP(std::uint64_t n);

/// Friedman's test if all n participants rank k conditions in the same order:
///
///     p = 1 / k!^(n − 1)
///
/// 1 for fewer than two participants.
/// @throws std::invalid_argument  for fewer than two conditions, or more than 1000.
AttainableP smallestFriedmanP(std::uint64_t n, int k);

/// Mann and Whitney's test of two groups that do not overlap and have no ties:
///
///     p = 2 / C(n₁ + n₂, n₁)
///
/// 1 if one group is empty.
AttainableP smallestMannWhitneyP(std::uint64_t n1, std::uint64_t n2);

/// The exact multinomial test of equal shares if all n votes are for the same one of k options:
///
///     p = k / kⁿ = k^(1 − n)
///
/// 1 without votes.
/// @throws std::invalid_argument  for fewer than two options, or more than 1000.
AttainableP smallestVoteP(std::uint64_t n, int k);

/// The fewest participants for which an exact paired test can have a p of at most @p level: the
/// smallest n with 2^(1 − n) ≤ level.
/// @throws std::invalid_argument  for a level that is not between 0 and 1.
std::uint64_t fewestParticipantsForSignFlip(double level);

/// The votes that one of k options needs for the exact multinomial test of equal shares to reach α,
/// however the other votes are distributed. std::nullopt if not even all n votes suffice, or if
/// there are too many votes for an exact test (see equalSharesP()).
/// @throws std::invalid_argument  for an alpha that is not between 0 and 1, fewer than two options,
///     or more than 1000.
std::optional<std::uint64_t> fewestVotesForSignificance(std::uint64_t n, int k, double alpha);

}  // namespace analysis
