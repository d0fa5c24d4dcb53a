#pragma once

#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace haptics::bench {

using HundredDigits = boost::multiprecision::cpp_bin_float_100;

/// The paper's string in 100 digits, by the matrix that our model never forms: elements of length 1
/// with the given stiffnesses, both ends fixed half an element from their midpoints (boundary A),
/// the tool shared by the two midpoints beside it; eliminated by Thomas' algorithm.
struct StringReference {
  HundredDigits stiffness;           ///< at the tool: 1 / (cᵀ K⁻¹ c) [N per travel unit]
  std::vector<HundredDigits> shape;  ///< K⁻¹ c

  /// @param toolPosition  at least half an element from both ends.
  StringReference(const std::vector<double>& elementStiffnesses, double toolPosition);
};

}  // namespace haptics::bench
