#pragma once

#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace haptics::bench {

using HundredDigits = boost::multiprecision::cpp_bin_float_100;

/// Reference solution of the paper's string in 100 digits, with the explicit matrix and Thomas'
/// algorithm: elements of length 1 with the given stiffnesses, both ends half an element from their
/// midpoints (boundary A), the tool interpolated between the two midpoints beside it, or between an
/// end and the midpoint beside that.
struct StringReference {
  HundredDigits stiffness;           ///< at the tool: 1 / (cᵀ K⁻¹ c) [N per travel unit]
  std::vector<HundredDigits> shape;  ///< K⁻¹ c, one entry per midpoint

  /// @param toolPosition  between 0 and the number of elements.
  StringReference(const std::vector<double>& elementStiffnesses, double toolPosition);
};

}  // namespace haptics::bench
