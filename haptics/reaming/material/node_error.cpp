#include "haptics/reaming/material/node_error.h"

#include <algorithm>
#include <cmath>

namespace haptics::reaming {

NodeError::NodeError(const SampledCurve& curve, const NodeWish& wish)
    : curve_(curve), wish_(wish), slopes_(dataSlopes(curve)) {
  if (wish.rule == NodeRule::PaperLiteral) wish_.floor = 0.0;
}

NodeError::Worst NodeError::of(
    const models::CubicSegment<double>& piece,
    std::size_t from,
    std::size_t to,
    double enough) const {
  Worst worst{.at = from + (to - from) / 2};
  for (std::size_t i = from + 1; i < to; ++i) {
    const double y = curve_.y[i];
    const double measure = std::max(std::abs(y), wish_.floor);
    if (measure == 0.0) continue;  // the paper's e_a is not defined there
    const double error = std::abs(piece.at(curve_.x[i]).force - y) / measure;
    if (error > worst.error) worst = {error, i};
    if (worst.error > enough) break;
  }
  return worst;
}

NodeError::Worst NodeError::between(std::size_t from, std::size_t to, double enough) const {
  models::HermiteNode<double> a{curve_.x[from], curve_.y[from], slopes_[from]};
  models::HermiteNode<double> b{curve_.x[to], curve_.y[to], slopes_[to]};
  if (wish_.kind == SplineKind::Linear) {
    a.slope = b.slope = (b.force - a.force) / (b.position - a.position);
  }
  return of(models::CubicSegment<double>::between(a, b), from, to, enough);
}

NodeError::Worst NodeError::through(std::span<const std::size_t> nodes, double enough) const {
  const auto spline = splineThrough(curve_, slopes_, nodes, wish_.kind);
  Worst worst;
  for (std::size_t i = 0; i + 1 < nodes.size() && worst.error <= enough; ++i) {
    const auto here = of(spline.segments[i], nodes[i], nodes[i + 1], enough);
    if (here.error > worst.error) worst = here;
  }
  return worst;
}

}  // namespace haptics::reaming
