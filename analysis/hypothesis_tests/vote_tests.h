#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/data/reason.h"
#include "analysis/data/vote_shares.h"

namespace analysis {

/// The p value of the exact multinomial test of equal shares: the probability, if all options are
/// equally likely, of outcomes that are not more probable than the observed one.
///
///     p = Σ n! / (v₁! … v_k!) / kⁿ
///
/// summed over all outcomes v with a term not larger than that of the observed outcome.
///
/// Computed in whole numbers up to kⁿ = 2¹²⁶ (126 votes on two options, 79 on three, 63 on four),
/// so that equal terms are recognised and p is correctly rounded; above by logarithms, to about ten
/// digits. Returns std::nullopt without votes, and for more than a million outcomes, which begins
/// at about 3500 votes on three options, 530 on four, 230 on five.
std::optional<double> equalSharesP(const VoteCounts& votes);

/// The result of the test of equal shares. If a number is missing, `reason` says why.
struct EqualSharesResult {
  std::uint64_t votes = 0;
  std::optional<double> exactP;            ///< see equalSharesP()
  std::optional<double> chiSquared;        ///< Σ (v − n/k)² / (n/k)
  std::optional<double> degreesOfFreedom;  ///< k − 1
  std::optional<double> p;                 ///< from χ²; a rough approximation for a few votes
  std::optional<double> log10P;            ///< defined even if p is too small for a double
  Reason reason;                           ///< why something above is missing; empty if nothing is
};

/// Tests whether all options are preferred equally often. Assumes independent votes: several votes
/// of one person make p too small.
EqualSharesResult equalSharesTest(const VoteCounts& votes);

/// The result of Cochran's Q test: whether all options get equally many yes answers, if each person
/// answers yes or no to each. If a number is missing, `reason` says why.
struct CochranResult {
  std::uint64_t persons = 0;
  std::uint64_t unvaryingPersons =
      0;  ///< persons who gave the same answer to all options; Q ignores them
  std::optional<double> q;
  std::optional<double> degreesOfFreedom;  ///< k − 1
  std::optional<double> p;                 ///< of χ²
  std::optional<double> log10P;            ///< defined even if p is too small for a double
  std::optional<double> exactP;            ///< over all permutations within persons
  Reason reason;                           ///< why something above is missing; empty if nothing is
};

/// Cochran's Q (1950), with Gⱼ the number of yes for option j and Lᵢ the number of yes of person i:
///
///     Q = (k − 1)(k ΣGⱼ² − (ΣGⱼ)²) / (k ΣLᵢ − ΣLᵢ²)
///
/// Equivalent to Friedman's test of zeros and ones; exactP is that of Friedman's test.
///
/// @param answers  a row per person, an answer per option.
/// @throws std::invalid_argument  for rows of different lengths, or fewer than two options.
CochranResult cochranQTest(std::span<const std::vector<bool>> answers);

}  // namespace analysis
