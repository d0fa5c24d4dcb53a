#include "haptics/recordings/slope_limit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace haptics::recordings {
namespace {

/// min_y (f(y) + K |x − y|), in place.
void lowerEnvelope(std::vector<CurvePoint>& nodes, double maxSlope) {
  const auto pull = [&](CurvePoint& node, const CurvePoint& neighbour) {
    const double reach = maxSlope * std::abs(node.travel - neighbour.travel);
    node.force = std::min(node.force, neighbour.force + reach);
  };
  for (std::size_t i = 1; i < nodes.size(); ++i) pull(nodes[i], nodes[i - 1]);
  for (std::size_t i = nodes.size() - 1; i > 0; --i) pull(nodes[i - 1], nodes[i]);
}

std::vector<CurvePoint> mirrored(std::vector<CurvePoint> nodes) {
  for (CurvePoint& node : nodes) node.force = -node.force;
  return nodes;
}

}  // namespace

SlopeLimited limitSlope(const ForceCurve& curve, double maxSlope) {
  if (!std::isfinite(maxSlope) || !(maxSlope > 0.0)) {
    throw std::invalid_argument("a slope limit is positive and finite");
  }
  std::vector<CurvePoint> lower = curve.nodes();
  lowerEnvelope(lower, maxSlope);
  std::vector<CurvePoint> upper = mirrored(curve.nodes());
  lowerEnvelope(upper, maxSlope);
  upper = mirrored(std::move(upper));

  double largestChange = 0.0;
  double largestChangeAt = curve.start();
  for (std::size_t i = 0; i < lower.size(); ++i) {
    const double before = curve.nodes()[i].force;
    lower[i].force = lower[i].force + (upper[i].force - lower[i].force) / 2.0;
    const double change = std::abs(lower[i].force - before);
    if (change <= largestChange) continue;
    largestChange = change;
    largestChangeAt = lower[i].travel;
  }
  return {ForceCurve(std::move(lower)), largestChange, largestChangeAt};
}

}  // namespace haptics::recordings
