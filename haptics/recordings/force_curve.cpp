#include "haptics/recordings/force_curve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace haptics::recordings {

ForceCurve::ForceCurve(std::vector<CurvePoint> nodes) : nodes_(std::move(nodes)) {
  if (nodes_.size() < 2) throw std::invalid_argument("a force curve has at least two nodes");
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (!std::isfinite(nodes_[i].travel) || !std::isfinite(nodes_[i].force)) {
      throw std::invalid_argument("node " + std::to_string(i + 1) + " of a curve is not finite");
    }
    if (i > 0 && !(nodes_[i].travel > nodes_[i - 1].travel)) {
      throw std::invalid_argument(
          "node " + std::to_string(i + 1) + " of a curve does not lie above the one before it");
    }
  }
}

double ForceCurve::forceAt(double travel) const noexcept {
  if (!(travel > start())) return nodes_.front().force;
  if (travel >= end()) return nodes_.back().force;
  const auto above = std::ranges::upper_bound(nodes_, travel, {}, &CurvePoint::travel);
  const CurvePoint& high = *above;
  const CurvePoint& low = *(above - 1);
  const double share = (travel - low.travel) / (high.travel - low.travel);
  return low.force + (high.force - low.force) * share;
}

double ForceCurve::largestSlope() const noexcept {
  double largest = 0.0;
  for (std::size_t i = 1; i < nodes_.size(); ++i) {
    const double slope =
        (nodes_[i].force - nodes_[i - 1].force) / (nodes_[i].travel - nodes_[i - 1].travel);
    largest = std::max(largest, std::abs(slope));
  }
  return largest;
}

}  // namespace haptics::recordings
