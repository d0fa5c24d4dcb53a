#include "haptics/reaming/material/material.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace haptics::reaming {
namespace {

/// Value and slope of a Hermite spline; constant beyond its ends.
models::HermiteNode<double> nodeAt(const CurveNodes& nodes, double x) {
  if (x <= nodes.front().position) {
    const bool isThere = x == nodes.front().position;
    return {x, nodes.front().force, isThere ? nodes.front().slope : 0.0};
  }
  if (x >= nodes.back().position) {
    const bool isThere = x == nodes.back().position;
    return {x, nodes.back().force, isThere ? nodes.back().slope : 0.0};
  }
  const auto after =
      std::upper_bound(nodes.begin(), nodes.end(), x, [](double value, const auto& node) {
        return value < node.position;
      });
  const auto piece = models::CubicSegment<double>::between(*(after - 1), *after);
  const auto response = piece.at(x);
  return {x, response.force, response.stiffness};
}

CurveNodes blended(const CurveNodes& a, const CurveNodes& b, double share) {
  std::vector<double> places;
  for (const auto* nodes : {&a, &b}) {
    for (const auto& node : *nodes) places.push_back(node.position);
  }
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  CurveNodes result;
  for (const double x : places) {
    const auto one = nodeAt(a, x);
    const auto other = nodeAt(b, x);
    result.push_back(
        {x,
         (1.0 - share) * one.force + share * other.force,
         (1.0 - share) * one.slope + share * other.slope});
  }
  return result;
}

}  // namespace

double HardnessCurves::end() const noexcept {
  return std::max({minimum.back().position, average.back().position, maximum.back().position});
}

double forceOf(const CurveNodes& nodes, double depth) {
  return nodeAt(nodes, depth).force;
}

CurveNodes curveOf(const HardnessCurves& curves, double h) {
  return h <= 0.5 ? blended(curves.minimum, curves.average, 2.0 * h)
                  : blended(curves.average, curves.maximum, 2.0 * h - 1.0);
}

std::optional<std::string> problemOf(const HardnessCurves& curves) {
  const std::array<std::pair<const char*, const CurveNodes*>, 3> all{
      {{"minimum", &curves.minimum}, {"average", &curves.average}, {"maximum", &curves.maximum}}};
  for (const auto& [name, nodes] : all) {
    const std::string which = std::string("the ") + name + " curve of the material";
    if (nodes->size() < 2) return which + " has fewer than two nodes";
    for (std::size_t i = 0; i < nodes->size(); ++i) {
      const auto& node = (*nodes)[i];
      if (!std::isfinite(node.position + node.force + node.slope)) {
        return which + " has a node that is no number";
      }
      if (i > 0 && !(node.position > (*nodes)[i - 1].position)) {
        return which + " has a node that does not lie deeper than the one before it";
      }
    }
  }
  return std::nullopt;
}

const MaterialSet* Material::find(TestSet set) const noexcept {
  const auto found = std::ranges::find_if(sets, [&](const auto& each) { return each.set == set; });
  return found != sets.end() ? &*found : nullptr;
}

}  // namespace haptics::reaming
