#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/data/reason.h"

namespace analysis {

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
