#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace analysis {

/// The exact p of Friedman's test: the probability of rank sums at least as unequal as these, if
/// all permutations of the ranks of a block are equally likely.
///
/// Counted in whole numbers by dynamic programming over the rank sums of all but one treatment.
/// Nothing without blocks, nor where there are too many: without ties from 127 blocks of two
/// treatments, 49 of three, 11 of four, 3 of five.
///
/// @param doubledRanks  a row per block, of as many doubled midranks as there are treatments.
std::optional<double> friedmanPermutationP(
    std::span<const std::vector<std::uint64_t>> doubledRanks);

}  // namespace analysis
