#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/data/reason.h"

namespace analysis {

/// Whether participants change from no to yes as often as from yes to no. What is missing has a
/// reason.
struct McNemarResult {
  std::uint64_t changedToYes = 0;
  std::uint64_t changedToNo = 0;
  std::optional<double> p;       ///< exact, two-sided: 2 P(heads ≤ the rarer change), at most 1
  std::optional<double> log10P;  ///< also where p is too small for a double
  std::optional<double> chiSquared;   ///< (b − c)²/(b + c), one degree of freedom, not corrected
  std::optional<double> pAsymptotic;  ///< of χ²
  Reason reason;                      ///< why something above is missing; empty if nothing is
};

/// McNemar's test (1947) of paired yes and no: under the null hypothesis each change is equally
/// likely in both directions; answers that did not change do not count.
McNemarResult mcNemarTest(std::uint64_t changedToYes, std::uint64_t changedToNo);

/// Whether options are chosen as often the second time as the first. What is missing has a reason.
struct StuartMaxwellResult {
  std::uint64_t persons = 0;
  std::uint64_t changed = 0;
  std::optional<double> chiSquared;
  std::optional<double> degreesOfFreedom;  ///< k − 1 if changes connect all options, or fewer
  std::optional<double> p;                 ///< of χ²
  std::optional<double> log10P;            ///< also where p is too small for a double
  Reason reason;                           ///< why something above is missing; empty if nothing is
};

/// Stuart's and Maxwell's test (1955, 1970) of equal margins of a square table nᵢⱼ, how many chose
/// i first and j then:
///
///     χ² = dᵀ S⁻¹ d,   dᵢ = nᵢ. − n.ᵢ,   Sᵢᵢ = nᵢ. + n.ᵢ − 2 nᵢᵢ,   Sᵢⱼ = −(nᵢⱼ + nⱼᵢ)
///
/// with one option left out. Where no answer changed between some options and the others, one is
/// left out on either side, and so for each such part.
///
/// @param table  at most 100 rows of as many counts below 2^32.
/// @throws std::invalid_argument  for a table that is not square, of fewer than two options, or
///     beyond these.
StuartMaxwellResult stuartMaxwellTest(std::span<const std::vector<std::uint64_t>> table);

/// Whether rows and columns of a table of counts are associated. What is missing has
/// its reason.
struct FisherExactResult {
  std::uint64_t total = 0;
  std::optional<double> p;  ///< exact: the sum over tables that are not more probable
  Reason reason;            ///< why p is missing; empty if it is not
};

/// Fisher's exact test (1935) of an r × c table, in Freeman & Halton's extension (1951): of all
/// tables with these margins, how probable is one that is not more probable than this?
///
///     P(table) = Π nᵢ.! Π n.ⱼ! / (n! Π nᵢⱼ!)
///
/// Every table is visited, rows and columns without counts left aside, with probabilities of 31
/// digits; two that agree to 20 are taken as equally probable. For at most 300 counts in all and
/// half a million tables.
///
/// @throws std::invalid_argument  for a table without rows, with rows of unlike length, or with a
///     count above 2^32.
FisherExactResult fisherExactTest(std::span<const std::vector<std::uint64_t>> table);

}  // namespace analysis
