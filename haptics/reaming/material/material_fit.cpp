#include "haptics/reaming/material/material_fit.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "haptics/filters/averages.h"
#include "haptics/filters/low_pass.h"
#include "haptics/reaming/material/envelope.h"

namespace haptics::reaming {
namespace {

NodeCriterion nodeCriterionOf(const FitOptions& options, double floor) {
  return {options.nodes, options.nodesOf.value_or(options.spline), options.wantedError, floor};
}

/// Whether the splines cannot cross by construction.
bool isOrdered(const FitOptions& options) {
  return options.envelope == EnvelopeRule::Pointwise && !options.nodeCount && !options.nodesOf &&
         canBeOrdered(nodeCriterionOf(options, 1.0));
}

NodeChoice nodesOf(const SampledCurve& data, double floor, const FitOptions& options) {
  const auto nodeCriterion = nodeCriterionOf(options, floor);
  return options.nodeCount
             ? chooseNodes(data, std::min(*options.nodeCount, data.size()), nodeCriterion)
             : chooseNodes(data, nodeCriterion);
}

/// Fits a spline to @p data.
FittedCurve fitted(const SampledCurve& data, double floor, const FitOptions& options) {
  FittedCurve curve{.data = data};
  const auto choice = nodesOf(data, floor, options);
  curve.spline = splineThrough(data, dataSlopes(data), choice.nodes, options.spline);
  curve.error = errorOf(data, curve.spline, floor);
  curve.isMet = options.nodeCount || choice.isMet;
  return curve;
}

FittedEnvelope fitted(DepthEnvelope envelope, double floor, const FitOptions& options) {
  FittedEnvelope result{
      .isOrdered = isOrdered(options),
      .measured = std::move(envelope.measured),
      .held = std::move(envelope.held)};
  const SampledCurve* const data[]{
      &envelope.curves.minimum, &envelope.curves.average, &envelope.curves.maximum};
  FittedCurve* const curves[]{&result.minimum, &result.average, &result.maximum};
  if (!result.isOrdered) {
    for (std::size_t c = 0; c < std::size(curves); ++c) {
      *curves[c] = fitted(*data[c], floor, options);
    }
    return result;
  }
  auto splines = orderedSplines(envelope.curves, nodeCriterionOf(options, floor));
  for (std::size_t c = 0; c < std::size(curves); ++c) {
    const auto error = errorOf(*data[c], splines[c], floor);
    *curves[c] = {*data[c], std::move(splines[c]), error};
  }
  return result;
}

/// A curve resampled at the abscissae of its test set.
SpecimenCurve specimenOf(
    const SampledCurve& curve, bool isCensored, double scale, const FitOptions& options) {
  if (options.axis == DepthAxis::NormalisedSeries) {
    SampledCurve stretched = curve;
    for (double& x : stretched.x) x *= scale / curve.x.back();
    return {std::move(stretched), scale, curve.y.back(), isCensored};
  }
  const double step = scale / static_cast<double>(kSampleCount - 1);
  return {
      resampled(curve, scale, kSampleCount), curve.x.back(), endValueOf(curve, step), isCensored};
}

DepthEnvelope envelopeOf(
    const std::vector<const PreparedSeries*>& all,
    SampledCurve PreparedSeries::*quantity,
    double scale,
    const FitOptions& options) {
  std::vector<SpecimenCurve> specimens;
  for (const auto* series : all) {
    const auto& curve = series->*quantity;
    if (curve.size() == 0) continue;
    specimens.push_back(specimenOf(curve, series->isCensored, scale, options));
  }
  return options.axis == DepthAxis::Depth ? depthEnvelopeOf(specimens, options.envelope)
                                          : envelopeOfRunningTests(specimens, options.envelope);
}

std::vector<double> filtered(
    const std::vector<double>& samples, const Series& series, double cutoff) {
  if (series.set == TestSet::Static) return samples;
  return filters::zeroPhaseLowPass(samples, series.rate, cutoff);
}

/// Resamples a signal over depth from the beginning of the test [m].
SampledCurve overDepth(const Series& series, const std::vector<double>& samples) {
  const auto all = curveOver(series.displacement, samples);
  auto curve = normalised(all, kSampleCount);
  for (double& x : curve.x) x *= all.x.back();
  return curve;
}

/// A force of at least this fraction of the limit counts as having reached it, because the
/// controller of the testing machine may stop a sample early.
constexpr double kShareOfForceLimit = 0.98;

TestSetFit fitOf(
    TestSet set, const std::vector<const PreparedSeries*>& used, const FitOptions& options) {
  TestSetFit result{.set = set, .used = static_cast<int>(used.size())};
  double variance = 0.0;
  bool hasTorque = false;
  for (const auto* series : used) {
    variance += series->jitter * series->jitter;
    result.scale = std::max(result.scale, series->largestDisplacement);
    hasTorque |= series->torque.size() > 0;
  }
  result.jitter.rms = std::sqrt(variance / static_cast<double>(used.size()));
  result.force = fitted(
      envelopeOf(used, &PreparedSeries::force, result.scale, options), options.forceFloor, options);
  if (hasTorque) {
    result.torque = fitted(
        envelopeOf(used, &PreparedSeries::torque, result.scale, options),
        options.torqueFloor,
        options);
  }
  return result;
}

}  // namespace

std::optional<std::string> problemOf(const FitOptions& options) {
  return options.nodeCount ? std::nullopt : problemOf(nodeCriterionOf(options, 1.0));
}

PreparedSeries prepared(const Series& series, const FitOptions& options) {
  PreparedSeries result{.name = series.name, .set = series.set, .exclusion = exclusionOf(series)};
  if (result.exclusion.isExcluded()) return result;
  const bool isFiltered = series.set != TestSet::Static;
  const auto cutoffFor = [&](const std::vector<double>& samples, std::optional<double> wanted) {
    return wanted ? *wanted : filters::cutoffOf(samples, series.rate, options.cutoffRule);
  };
  if (isFiltered) result.cutoff = cutoffFor(series.force, options.cutoff);
  const auto cleaned = filtered(series.force, series, result.cutoff);
  result.jitter = filters::rmsDifference(series.force, cleaned);
  result.force = overDepth(series, cleaned);
  result.largestDisplacement = result.force.x.back();
  result.isCensored =
      !isFiltered && result.force.y.back() >= kShareOfForceLimit * options.forceLimit;
  if (series.torque.empty()) return result;
  if (isFiltered) result.torqueCutoff = cutoffFor(series.torque, options.torqueCutoff);
  result.torque = overDepth(series, filtered(series.torque, series, result.torqueCutoff));
  return result;
}

std::vector<SpecimenCounts> specimenCountsOf(const FittedEnvelope& envelope) {
  std::vector<SpecimenCounts> left;
  const auto& depths = envelope.average.data.x;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const SpecimenCounts here{depths[i], envelope.measured[i], envelope.held[i]};
    const bool isSame =
        !left.empty() && left.back().measured == here.measured && left.back().held == here.held;
    if (!isSame) left.push_back(here);
  }
  return left;
}

std::vector<std::string> optionsAgainstCrossing(const FitOptions& options) {
  std::vector<std::string> changes;
  if (options.envelope != EnvelopeRule::Pointwise) changes.emplace_back("--envelope pointwise");
  if (options.spline == SplineKind::NaturalCubic) {
    changes.emplace_back("--spline hermite-data-slope");
  }
  if (options.nodeCount || !canBeOrdered({options.nodes, SplineKind::HermiteDataSlope})) {
    changes.emplace_back("--nodes greedy");
  }
  if (options.nodesOf) changes.emplace_back("no --nodes-of");
  return changes;
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
    std::vector<const PreparedSeries*> used;
    double rate = Jitter{}.rate;
    for (std::size_t i = 0; i < series.size(); ++i) {
      const auto& each = fit.series[i];
      if (each.set != set || each.exclusion.isExcluded()) continue;
      rate = series[i].rate;
      used.push_back(&each);
    }
    if (used.empty()) continue;
    fit.sets.push_back(fitOf(set, used, options));
    fit.sets.back().jitter.rate = rate;
  }
  return fit;
}

}  // namespace haptics::reaming
