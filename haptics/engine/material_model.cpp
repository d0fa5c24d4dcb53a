#include "haptics/engine/material_model.h"

#include <algorithm>
#include <cmath>

namespace haptics::engine {
namespace {

/// The three-point slope at an end, limited so that it neither turns nor overshoots.
double endSlope(double h0, double h1, double rise0, double rise1) {
  const double slope = ((2.0 * h0 + h1) * rise0 - h0 * rise1) / (h0 + h1);
  if (slope * rise0 <= 0.0) return 0.0;
  if (rise0 * rise1 <= 0.0 && std::abs(slope) > 3.0 * std::abs(rise0)) return 3.0 * rise0;
  return slope;
}

std::vector<double> knotsOf(const std::vector<models::CubicSegment<double>>& segments) {
  std::vector<double> knots;
  for (const auto& segment : segments) knots.push_back(segment.begin);
  knots.push_back(segments.back().end);
  return knots;
}

}  // namespace

std::vector<double> monotoneSlopes(
    const std::vector<double>& positions, const std::vector<double>& values) {
  const std::size_t n = positions.size();
  std::vector<double> h(n - 1);
  std::vector<double> rise(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    h[i] = positions[i + 1] - positions[i];
    rise[i] = (values[i + 1] - values[i]) / h[i];
  }
  if (n == 2) return {rise[0], rise[0]};

  std::vector<double> slopes(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    if (rise[i - 1] * rise[i] <= 0.0) continue;
    const double w1 = 2.0 * h[i] + h[i - 1];
    const double w2 = h[i] + 2.0 * h[i - 1];
    slopes[i] = (w1 + w2) / (w1 / rise[i - 1] + w2 / rise[i]);
  }
  slopes[0] = endSlope(h[0], h[1], rise[0], rise[1]);
  slopes[n - 1] = endSlope(h[n - 2], h[n - 3], rise[n - 2], rise[n - 3]);
  return slopes;
}

std::vector<models::CubicSegment<double>> blendedSegments(const MaterialSpec& spec) {
  std::vector<double> depths;
  std::vector<double> lower;
  std::vector<double> upper;
  for (const auto& node : spec.nodes) {
    depths.push_back(node.depth);
    lower.push_back(node.lower);
    upper.push_back(node.upper);
  }
  const auto lowerSlopes = monotoneSlopes(depths, lower);
  const auto upperSlopes = monotoneSlopes(depths, upper);
  const double h = spec.hardness;
  std::vector<models::HermiteNode<double>> nodes;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    nodes.push_back(
        {depths[i],
         spec.forceScale * ((1.0 - h) * lower[i] + h * upper[i]),
         spec.forceScale * ((1.0 - h) * lowerSlopes[i] + h * upperSlopes[i])});
  }
  std::vector<models::CubicSegment<double>> segments;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    segments.push_back(models::CubicSegment<double>::between(nodes[i], nodes[i + 1]));
  }
  return segments;
}

MaterialModel::MaterialModel(const MaterialSpec& spec)
    : segments_(blendedSegments(spec)),
      table_(knotsOf(segments_)),
      curve_(segments_.data(), segments_.size(), table_.index()) {}

double MaterialModel::largestStiffness() const noexcept {
  // The slope of a cubic is a parabola: largest at an end of its interval or at its apex.
  double largest = 0.0;
  for (const auto& segment : segments_) {
    const double apex = segment.begin - segment.square / (3.0 * segment.cube);
    const bool isInside = apex > segment.begin && apex < segment.end;  // not where cube is 0
    for (const double x : {segment.begin, segment.end, isInside ? apex : segment.begin}) {
      largest = std::max(largest, std::abs(segment.at(x).stiffness));
    }
  }
  return largest;
}

}  // namespace haptics::engine
