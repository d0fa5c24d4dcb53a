#pragma once

#include <vector>

namespace haptics::reaming {

/// Slopes at the nodes of a curve that keep its cubic Hermite spline from overshooting: weighted
/// harmonic means inside, one-sided at the ends (Fritsch & Butland 1984, "PCHIP").
///
/// @param positions  two or more, rising strictly; as many values.
std::vector<double> monotoneSlopes(
    const std::vector<double>& positions, const std::vector<double>& values);

}  // namespace haptics::reaming
