#include "haptics/reaming/material/spline_comparison.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace haptics::reaming {
namespace {

/// The sample at @p x.
std::size_t sampleAt(const SampledCurve& curve, double x) {
  const auto found = std::lower_bound(curve.x.begin(), curve.x.end(), x);
  return static_cast<std::size_t>(found - curve.x.begin());
}

double off(const SampledCurve& curve, const Spline& spline, std::size_t i) {
  return std::abs(spline.at(curve.x[i]) - curve.y[i]);
}

}  // namespace

SplineComparison compareSplines(
    const SampledCurve& curve, std::vector<std::size_t> nodes, double floor) {
  SplineComparison comparison{.nodes = std::move(nodes)};
  const auto slopes = dataSlopes(curve);
  for (const auto kind : {SplineKind::NaturalCubic, SplineKind::HermiteDataSlope}) {
    ComparedSpline compared{
        .kind = kind, .spline = splineThrough(curve, slopes, comparison.nodes, kind)};
    compared.error = errorOf(curve, compared.spline, floor);
    const auto& first = comparison.splines.empty() ? compared : comparison.splines.front();
    const auto published = sampleAt(curve, first.error.publishedAt);
    const auto floored = sampleAt(curve, first.error.flooredAt);
    const double v = std::abs(curve.y[published]);
    if (v > 0.0) compared.publishedThere = off(curve, compared.spline, published) / v;
    compared.flooredThere =
        off(curve, compared.spline, floored) / std::max(std::abs(curve.y[floored]), floor);
    comparison.splines.push_back(std::move(compared));
  }
  return comparison;
}

}  // namespace haptics::reaming
