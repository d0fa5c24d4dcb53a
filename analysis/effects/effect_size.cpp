#include "analysis/effects/effect_size.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <boost/math/special_functions/gamma.hpp>

#include "analysis/data/moments.h"
#include "analysis/numerics/student_distribution.h"
#include "analysis/tests/welch.h"

namespace analysis {
namespace {

void checkLevel(double level) {
  if (!(level > 0.0 && level < 1.0)) {
    throw std::invalid_argument("a confidence level lies between 0 and 1");
  }
}

/// difference / deviation; nothing without spread, or beyond a double.
std::optional<double> ratio(const Contrast& contrast, const DoubleDouble& variance) {
  if (variance.isZero()) return std::nullopt;
  const double effect = tOf(contrast, squareRoot(variance));
  return std::isfinite(effect) ? std::optional(effect) : std::nullopt;
}

/// The interval of the noncentrality, times the factor from noncentrality to effect size.
std::optional<Interval> intervalOf(double t, double degreesOfFreedom, double level, double factor) {
  constexpr double kLargestT = 1e100;
  if (std::abs(t) > kLargestT) return std::nullopt;
  const Interval limits = noncentralityInterval(t, degreesOfFreedom, level);
  return Interval{.low = limits.low * factor, .high = limits.high * factor};
}

EffectSize corrected(const EffectSize& effect, const std::optional<double>& correction) {
  EffectSize result;
  if (!correction) return result;
  if (effect.value) result.value = *correction * *effect.value;
  if (effect.interval) {
    result.interval = Interval{
        .low = *correction * effect.interval->low, .high = *correction * effect.interval->high};
  }
  return result;
}

void addPooled(MeanEffects& effects, const Contrast& contrast, double n1, double n2) {
  const double degreesOfFreedom = n1 + n2 - 2.0;
  const DoubleDouble squares = contrast.variance1 * (n1 - 1.0) + contrast.variance2 * (n2 - 1.0);
  effects.cohenD.value = ratio(contrast, squares / degreesOfFreedom);
  effects.hedgesJ = hedgesCorrection(degreesOfFreedom);
  if (effects.cohenD.value) {
    const double root = std::sqrt(1.0 / n1 + 1.0 / n2);
    const double t = *effects.cohenD.value / root;
    effects.cohenD.interval = intervalOf(t, degreesOfFreedom, effects.level, root);
  }
  effects.hedgesG = corrected(effects.cohenD, effects.hedgesJ);
}

void addAverage(
    MeanEffects& effects,
    const Contrast& contrast,
    const WelchResult& welch,
    double n1,
    double n2) {
  const DoubleDouble sum = contrast.variance1 + contrast.variance2;
  effects.cohenDAv.value = ratio(contrast, sum / 2.0);
  effects.glassDelta1 = ratio(contrast, contrast.variance1);
  effects.glassDelta2 = ratio(contrast, contrast.variance2);
  if (!sum.isZero()) {
    const double z = tOf(contrast, squareRoot(sum));
    effects.commonLanguage = 0.5 * std::erfc(-z / std::numbers::sqrt2);
  }
  if (!welch.degreesOfFreedom) return;

  effects.hedgesJAv = hedgesCorrection(*welch.degreesOfFreedom);
  if (effects.cohenDAv.value && std::isfinite(*welch.t)) {
    const DoubleDouble ofMeans = contrast.variance1 / n1 + contrast.variance2 / n2;
    const double root = squareRoot(ofMeans / (sum / 2.0)).high;
    effects.cohenDAv.interval = intervalOf(*welch.t, *welch.degreesOfFreedom, effects.level, root);
  }
  effects.hedgesGAv = corrected(effects.cohenDAv, effects.hedgesJAv);
}

Reason whyMissing(const MeanEffects& effects, const WelchResult& welch) {
  if (welch.n1 < 2 || welch.n2 < 2) {
    return reason("a_group_has_no_deviation");
  }
  if (!welch.degreesOfFreedom) {
    return reason("both_constant_no_deviation");
  }
  if (!effects.cohenD.interval || !effects.cohenDAv.interval) {
    return reason("too_many_standard_errors");
  }
  if (!effects.glassDelta1 || !effects.glassDelta2) {
    return reason("a_group_is_constant");
  }
  if (!effects.hedgesJAv) return reason("one_degree_of_freedom");
  return {};
}

}  // namespace

std::optional<double> hedgesCorrection(double degreesOfFreedom) {
  if (!(degreesOfFreedom > 1.0)) return std::nullopt;
  const double half = 0.5 * degreesOfFreedom;
  // As a ratio: each Γ for itself overflows for ν above 340.
  return 1.0 / (std::sqrt(half) * boost::math::tgamma_delta_ratio(half - 0.5, 0.5));
}

MeanEffects effectSizes(
    std::span<const double> values1, std::span<const double> values2, double level) {
  checkLevel(level);
  const Moments group1 = momentsOf(values1);
  const Moments group2 = momentsOf(values2);
  MeanEffects effects;
  effects.level = level;
  const Contrast contrast = contrastOf(group1, group2);
  const WelchResult welch = welchTTest(group1, group2);
  const auto n1 = static_cast<double>(group1.n);
  const auto n2 = static_cast<double>(group2.n);
  if (group1.n > 0 && group2.n > 0 && group1.n + group2.n > 2) {
    addPooled(effects, contrast, n1, n2);
  }
  if (group1.n > 1 && group2.n > 1) addAverage(effects, contrast, welch, n1, n2);
  effects.reason = whyMissing(effects, welch);
  return effects;
}

PairedEffects effectSizes(const PairedTResult& test, double level) {
  checkLevel(level);
  PairedEffects effects;
  effects.level = level;
  if (!test.t || !test.degreesOfFreedom) {
    effects.reason = test.reason;
    return effects;
  }
  const double root = std::sqrt(static_cast<double>(test.n));
  effects.cohenDz.value = *test.t / root;
  effects.cohenDz.interval = intervalOf(*test.t, *test.degreesOfFreedom, level, 1.0 / root);
  effects.hedgesJ = hedgesCorrection(*test.degreesOfFreedom);
  effects.hedgesGz = corrected(effects.cohenDz, effects.hedgesJ);
  if (!effects.cohenDz.interval) effects.reason = reason("too_many_standard_errors");
  if (!effects.hedgesJ) effects.reason = reason("two_pairs_only");
  return effects;
}

}  // namespace analysis
