#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "haptics/recordings/force_curve.h"

namespace haptics::recordings {

/// The mean of several curves, where all of them are, and how far they lie apart.
struct MeanCurve {
  ForceCurve curve;               ///< kNodes nodes, evenly spaced
  std::vector<double> deviation;  ///< standard deviation of the forces at each node, n − 1 [N]

  static constexpr std::size_t kNodes = 201;
};

/// Nothing if there are no curves, or no travel that all of them share.
std::optional<MeanCurve> meanCurve(std::span<const ForceCurve> curves);

/// Which of the curves is least far from their mean: the index (from 0) of the smallest
/// root-mean-square difference over the mean's nodes, the first of equals. Nothing if there is no
/// mean.
std::optional<std::size_t> mostTypical(std::span<const ForceCurve> curves);

}  // namespace haptics::recordings
