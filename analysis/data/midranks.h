#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/numerics/exact_quotient.h"

namespace analysis {

/// The ranks of values from the smallest, 1, to the largest; equal values share the mean of the
/// ranks that they take up.
struct Midranks {
  std::vector<std::uint64_t>
      doubled;      ///< twice the rank, a whole number, in the order of the values
  Wide tieSum = 0;  ///< Σ (t³ − t) over the groups of t equal values
};

/// @throws std::invalid_argument  if a value is infinite or no number.
Midranks midranksOf(std::span<const double> values);

}  // namespace analysis
