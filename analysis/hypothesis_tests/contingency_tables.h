#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/data/reason.h"

namespace analysis {

/// The result of McNemar's test. If a number is missing, `reason` says why.
struct McNemarResult {
  std::uint64_t changedToYes = 0;
  std::uint64_t changedToNo = 0;
  /// Exact, two-sided: 2 P(B ≤ the rarer change), B binomial with ½, at most 1.
  std::optional<double> p;
  std::optional<double> log10P;       ///< defined even if p is too small for a double
  std::optional<double> chiSquared;   ///< (b − c)²/(b + c), one degree of freedom, not corrected
  std::optional<double> pAsymptotic;  ///< of χ²
  Reason reason;                      ///< why something above is missing; empty if nothing is
};

/// McNemar's test (1947) of paired yes/no answers: do participants change from no to yes as often
/// as from yes to no? Answers that did not change are ignored.
McNemarResult mcNemarTest(std::uint64_t changedToYes, std::uint64_t changedToNo);

/// The result of the Stuart–Maxwell test: whether options are chosen as often the second time as
/// the first. If a number is missing, `reason` says why.
struct StuartMaxwellResult {
  std::uint64_t persons = 0;
  std::uint64_t changed = 0;
  std::optional<double> chiSquared;
  std::optional<double> degreesOfFreedom;  ///< k − 1 if changes connect all options, or fewer
  std::optional<double> p;                 ///< of χ²
  std::optional<double> log10P;            ///< defined even if p is too small for a double
  Reason reason;                           ///< why something above is missing; empty if nothing is
};

/// The Stuart–Maxwell test (1955, 1970) of equal margins of a square table, where nᵢⱼ persons chose
/// i first and j later:
///
///     χ² = dᵀ S⁻¹ d,   dᵢ = nᵢ. − n.ᵢ,   Sᵢᵢ = nᵢ. + n.ᵢ − 2 nᵢᵢ,   Sᵢⱼ = −(nᵢⱼ + nⱼᵢ)
///
/// with one option left out of d and S. If no answer changed between some options and the others,
/// the options form several parts, and one option is left out of each part.
///
/// @param table  square, with at most 100 rows and counts below 2^32.
/// @throws std::invalid_argument  for another table, or fewer than two options.
StuartMaxwellResult stuartMaxwellTest(std::span<const std::vector<std::uint64_t>> table);

/// The result of Fisher's exact test: whether rows and columns of a table of counts are associated.
/// If p is missing, `reason` says why.
struct FisherExactResult {
  std::uint64_t total = 0;
  std::optional<double> p;  ///< exact: the sum over tables that are not more probable
  Reason reason;            ///< why p is missing; empty if p is defined
};

/// Fisher's exact test (1935) of an r × c table, in Freeman & Halton's extension (1951): under
/// independence and with these margins, how probable are tables that are not more probable than
/// this one?
///
///     P(table) = Π nᵢ.! Π n.ⱼ! / (n! Π nᵢⱼ!)
///
/// Enumerates all tables, without empty rows and columns. Probabilities have 31 digits; two that
/// agree to 20 digits are treated as equal. For a total count of at most 300, and at most half a
/// million tables.
///
/// @throws std::invalid_argument  for a table without rows, with rows of unlike length, or with a
///     count above 2^32.
FisherExactResult fisherExactTest(std::span<const std::vector<std::uint64_t>> table);

}  // namespace analysis
