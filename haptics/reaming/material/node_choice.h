#pragma once

#include <cstddef>
#include <vector>

#include "haptics/reaming/material/sampled_curve.h"

namespace haptics::reaming {

/// Which samples of a curve become nodes of its Hermite spline.
enum class NodeRule {
  Greedy,        ///< split the worst piece where it is worst, until the error is met
  PaperLiteral,  ///< every sample whose |f″| is above a threshold, which falls until it is met
  Thinned,       ///< of each run of such samples its middle
  Optimal,       ///< as few as there can be, by dynamic programming over at most 2,000 samples
};

/// Nodes as indices into the curve, rising, with both ends; the error that they leave is at most
/// what was wanted, but for Thinned and PaperLiteral where no threshold does it.
struct NodeChoice {
  std::vector<std::size_t> nodes;
  double error = 0.0;  ///< max |v − v̂| / max(|v|, floor) of the Hermite spline with data slopes
};

/// @param wanted  the largest error, as a share, > 0. @param floor  see ApproximationError, > 0.
NodeChoice chooseNodes(const SampledCurve& curve, double wanted, double floor, NodeRule rule);

}  // namespace haptics::reaming
