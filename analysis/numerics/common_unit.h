#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace analysis {

/// Numbers as whole multiples of 1/denominator.
struct Multiples {
  std::vector<std::int64_t> multiples;
  std::int64_t denominator = 1;
};

/// The smallest q ≤ 1000 such that all numbers are whole multiples of 1/q, but for the rounding of
/// their last digits (1e-12 of the largest). Nothing where there is none: measured values.
///
/// Means of a few answers are such multiples; computed as doubles, two that should be equal often
/// differ in the last digit.
///
/// @throws std::invalid_argument  if a value is infinite or no number.
std::optional<Multiples> commonUnitOf(std::span<const double> numbers);

/// The numbers as the doubles nearest to their multiples of a common unit, so that what should be
/// equal is equal; as they are where there is no such unit.
/// @throws std::invalid_argument  as above.
std::vector<double> withoutRoundingNoise(std::span<const double> numbers);

}  // namespace analysis
