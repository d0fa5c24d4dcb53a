#include "haptics/reaming/material/material_fit.h"

#include <algorithm>
#include <cmath>

namespace haptics::reaming {
namespace {

constexpr std::size_t kPlaces = 2001;  // of a normalised curve

/// The data at given displacements as a spline.
FittedCurve fitted(
    const SampledCurve& shares, double scale, double floor, const FitOptions& options) {
  FittedCurve curve{.data = shares};
  for (double& x : curve.data.x) x *= scale;
  const auto choice = chooseNodes(curve.data, options.wantedError, floor, options.nodes);
  curve.spline = splineThrough(curve.data, dataSlopes(curve.data), choice.nodes, options.spline);
  curve.error = errorOf(curve.data, curve.spline, floor);
  return curve;
}

FittedEnvelope fitted(
    const std::vector<SampledCurve>& curves,
    double scale,
    double floor,
    const FitOptions& options) {
  const Envelope envelope = envelopeOf(curves, options.envelope);
  return {
      fitted(envelope.minimum, scale, floor, options),
      fitted(envelope.average, scale, floor, options),
      fitted(envelope.maximum, scale, floor, options)};
}

double rmsBetween(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

std::vector<double> filtered(
    const std::vector<double>& samples, const Series& series, double cutoff) {
  if (series.set == TestSet::Static) return samples;
  return zeroPhaseLowPass(samples, series.rate, cutoff);
}

}  // namespace

PreparedSeries prepared(const Series& series, const FitOptions& options) {
  PreparedSeries result{.name = series.name, .set = series.set, .exclusion = exclusionOf(series)};
  if (result.exclusion.isExcluded()) return result;
  if (series.set != TestSet::Static) {
    result.cutoff =
        options.cutoff.value_or(cutoffOf(series.force, series.rate, options.cutoffRule));
  }
  const auto cleaned = filtered(series.force, series, result.cutoff);
  result.jitter = rmsBetween(series.force, cleaned);
  const auto force = curveOver(series.displacement, cleaned);
  result.largestDisplacement = force.x.back();
  result.force = normalised(force, kPlaces);
  if (!series.torque.empty()) {
    const auto torque =
        curveOver(series.displacement, filtered(series.torque, series, result.cutoff));
    result.torque = normalised(torque, kPlaces);
  }
  return result;
}

std::vector<Crossing> crossingsOf(const FittedEnvelope& envelope, double tolerance) {
  std::vector<Crossing> crossings;
  bool isInside = false;
  for (const double x : envelope.average.data.x) {
    const double middle = envelope.average.spline.at(x);
    const bool isOut = envelope.minimum.spline.at(x) > middle + tolerance ||
                       middle > envelope.maximum.spline.at(x) + tolerance;
    if (isOut && !isInside) crossings.push_back({x, x});
    if (isOut) crossings.back().to = x;
    isInside = isOut;
  }
  return crossings;
}

MaterialFit fitMaterial(std::span<const Series> series, const FitOptions& options) {
  MaterialFit fit;
  for (const auto& each : series) fit.series.push_back(prepared(each, options));
  for (const TestSet set : {TestSet::Static, TestSet::Dynamic1, TestSet::Dynamic2}) {
    TestSetFit result{.set = set};
    std::vector<SampledCurve> forces;
    std::vector<SampledCurve> torques;
    double variance = 0.0;
    for (std::size_t i = 0; i < series.size(); ++i) {
      const auto& each = fit.series[i];
      if (each.set != set || each.exclusion.isExcluded()) continue;
      variance += each.jitter * each.jitter;
      result.jitter.rate = series[i].rate;
      forces.push_back(each.force);
      if (each.torque.size() > 0) torques.push_back(each.torque);
      result.scale = std::max(result.scale, each.largestDisplacement);
    }
    if (forces.empty()) continue;
    result.used = static_cast<int>(forces.size());
    result.jitter.rms = std::sqrt(variance / static_cast<double>(forces.size()));
    result.force = fitted(forces, result.scale, options.forceFloor, options);
    if (!torques.empty()) {
      result.torque = fitted(torques, result.scale, options.torqueFloor, options);
    }
    fit.sets.push_back(std::move(result));
  }
  return fit;
}

}  // namespace haptics::reaming
