#include "haptics/reaming/material/ordered_splines.h"

#include <algorithm>
#include <cmath>

namespace haptics::reaming {
namespace {

using HermiteNodes = std::vector<models::HermiteNode<double>>;

/// How far the slope of @p upper may lie above that of @p lower at node @p i, brought into bounds.
double boundedDifference(const HermiteNodes& lower, const HermiteNodes& upper, std::size_t i) {
  const double gap = std::max(0.0, upper[i].force - lower[i].force);
  double difference = upper[i].slope - lower[i].slope;
  if (i > 0) {
    difference = std::min(difference, 3.0 * gap / (upper[i].position - upper[i - 1].position));
  }
  if (i + 1 < upper.size()) {
    difference = std::max(difference, -3.0 * gap / (upper[i + 1].position - upper[i].position));
  }
  return difference;
}

/// Slopes of neighbours brought together where they could meet; those of the middle curve stay.
void bringTogether(EnvelopeSplines& splines) {
  auto& [low, middle, high] = splines;
  for (std::size_t i = 0; i < middle.nodes.size(); ++i) {
    const double below = boundedDifference(low.nodes, middle.nodes, i);
    const double above = boundedDifference(middle.nodes, high.nodes, i);
    low.nodes[i].slope = middle.nodes[i].slope - below;
    high.nodes[i].slope = middle.nodes[i].slope + above;
  }
  low = splineOf(low.nodes);
  high = splineOf(high.nodes);
}

struct Worst {
  double error = 0.0;
  std::size_t at = 0;
};

Worst worstOf(const SampledCurve& curve, const Spline& spline, double floor) {
  Worst worst;
  std::size_t piece = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    while (piece + 1 < spline.segments.size() && spline.segments[piece].end < curve.x[i]) ++piece;
    const double off = std::abs(spline.segments[piece].at(curve.x[i]).force - curve.y[i]);
    const double error = off / std::max(std::abs(curve.y[i]), floor);
    if (error > worst.error) worst = {error, i};
  }
  return worst;
}

/// Adds @p at; says whether it was no node yet.
bool addNode(std::vector<std::size_t>& nodes, std::size_t at) {
  const auto place = std::lower_bound(nodes.begin(), nodes.end(), at);
  if (place != nodes.end() && *place == at) return false;
  nodes.insert(place, at);
  return true;
}

}  // namespace

EnvelopeSplines orderedSplines(const Envelope& envelope, const NodeWish& wish) {
  const std::array<const SampledCurve*, 3> curves{
      &envelope.minimum, &envelope.average, &envelope.maximum};
  std::vector<std::size_t> nodes;
  std::array<std::vector<double>, 3> slopes;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const auto own = chooseNodes(*curves[c], wish).nodes;
    nodes.insert(nodes.end(), own.begin(), own.end());
    slopes[c] = dataSlopes(*curves[c]);
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  while (true) {
    EnvelopeSplines splines;
    for (std::size_t c = 0; c < curves.size(); ++c) {
      splines[c] = splineThrough(*curves[c], slopes[c], nodes, wish.kind);
    }
    // Straight lines between values that are in order are in order.
    if (wish.kind != SplineKind::Linear) bringTogether(splines);
    bool hasAdded = false;
    for (std::size_t c = 0; c < curves.size(); ++c) {
      const auto worst = worstOf(*curves[c], splines[c], wish.floor);
      if (worst.error > wish.error) hasAdded |= addNode(nodes, worst.at);
    }
    if (!hasAdded) return splines;
  }
}

}  // namespace haptics::reaming
