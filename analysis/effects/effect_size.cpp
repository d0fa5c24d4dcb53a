#include "analysis/effects/effect_size.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <boost/math/special_functions/gamma.hpp>

#include "analysis/data/moments.h"
#include "analysis/hypothesis_tests/t_tests.h"
#include "analysis/numerics/distributions.h"
#include "analysis/numerics/exact_arithmetic.h"
#include "analysis/numerics/tail_probabilities.h"

namespace analysis {
namespace {

/// difference / standard deviation; std::nullopt for a variance of zero, or beyond a double.
std::optional<double> ratioToDeviation(const Contrast& contrast, const DoubleDouble& variance) {
  if (variance.isZero()) return std::nullopt;
  const double effect = tOf(contrast, squareRoot(variance));
  return std::isfinite(effect) ? std::optional(effect) : std::nullopt;
}

/// The confidence interval of the noncentrality, times @p factor, which converts it into an effect
/// size.
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

void addPooledEffects(MeanEffects& effects, const Contrast& contrast, double n1, double n2) {
  const double degreesOfFreedom = n1 + n2 - 2.0;
  const DoubleDouble squares = contrast.variance1 * (n1 - 1.0) + contrast.variance2 * (n2 - 1.0);
  effects.cohenD.value = ratioToDeviation(contrast, squares / degreesOfFreedom);
  effects.hedgesJ = hedgesCorrection(degreesOfFreedom);
  if (effects.cohenD.value) {
    const double root = std::sqrt(1.0 / n1 + 1.0 / n2);
    const double t = *effects.cohenD.value / root;
    effects.cohenD.interval = intervalOf(t, degreesOfFreedom, effects.level, root);
  }
  effects.hedgesG = corrected(effects.cohenD, effects.hedgesJ);
}

void addAverageEffects(
    MeanEffects& effects,
    const Contrast& contrast,
    const WelchResult& welch,
    double n1,
    double n2) {
  const DoubleDouble sum = contrast.variance1 + contrast.variance2;
  effects.cohenDAv.value = ratioToDeviation(contrast, sum / 2.0);
  effects.glassDelta1 = ratioToDeviation(contrast, contrast.variance1);
  effects.glassDelta2 = ratioToDeviation(contrast, contrast.variance2);
  if (!sum.isZero()) {
    const double z = tOf(contrast, squareRoot(sum));
    effects.commonLanguageEffectSize = normalUpperP(-z);
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
  // Computed as a ratio, because each Γ alone overflows for ν above 340.
  return 1.0 / (std::sqrt(half) * boost::math::tgamma_delta_ratio(half - 0.5, 0.5));
}

MeanEffects effectSizes(
    std::span<const double> values1, std::span<const double> values2, double level) {
  requireConfidenceLevel(level);
  const Moments group1 = momentsOf(values1);
  const Moments group2 = momentsOf(values2);
  MeanEffects effects;
  effects.level = level;
  const Contrast contrast = contrastOf(group1, group2);
  const WelchResult welch = welchTTest(group1, group2);
  const auto n1 = static_cast<double>(group1.n);
  const auto n2 = static_cast<double>(group2.n);
  if (group1.n > 0 && group2.n > 0 && group1.n + group2.n > 2) {
    addPooledEffects(effects, contrast, n1, n2);
  }
  if (group1.n > 1 && group2.n > 1) addAverageEffects(effects, contrast, welch, n1, n2);
  effects.reason = whyMissing(effects, welch);
  return effects;
}

PairedEffects effectSizes(const PairedTResult& test, double level) {
  requireConfidenceLevel(level);
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

namespace {

/// The unbiased variance of δ, computed in whole numbers: with Pᵢ and Qⱼ the doubled placements,
///
///     (Σ(P − P̄)² + Σ(Q − Q̄)² − Σ(sign − δ)²) / (n₁n₂ (n₁ − 1)(n₂ − 1)).
DoubleDouble unbiasedVariance(const TiedGroups& groups, const Placements& placements) {
  const auto n1 = static_cast<Int128>(groups.n1);
  const auto n2 = static_cast<Int128>(groups.n2);
  const Int128 pairs = n1 * n2;
  const Int128 excess = placements.sum1 - pairs;
  const Int128 numerator =
      pairs * (placements.squares1 + placements.squares2 - pairs + placements.equalPairs) -
      n2 * placements.sum1 * placements.sum1 - n1 * placements.sum2 * placements.sum2 +
      excess * excess;
  return exactQuotient(numerator, pairs) / exactQuotient(pairs, 1) /
         exactQuotient((n1 - 1) * (n2 - 1), 1);
}

Interval fengCliffInterval(
    const DoubleDouble& delta,
    const DoubleDouble& oneMinusSquare,
    const DoubleDouble& variance,
    double z) {
  const DoubleDouble reach = variance * z * z;
  const DoubleDouble middle = delta * oneMinusSquare;
  const DoubleDouble radius = squareRoot(reach * (oneMinusSquare * oneMinusSquare + reach));
  const DoubleDouble denominator = oneMinusSquare + reach;
  return {
      .low = ((middle - radius) / denominator).high,
      .high = ((middle + radius) / denominator).high};
}

void addVarianceAndInterval(
    CliffDelta& result, const TiedGroups& groups, const Placements& placements, double z) {
  const auto pairs = static_cast<Int128>(groups.n1) * static_cast<Int128>(groups.n2);
  const Int128 excess = placements.sum1 - pairs;
  const DoubleDouble variance = unbiasedVariance(groups, placements);
  result.variance = variance.high;
  if (excess == pairs || excess == -pairs) {
    result.reason = reason("no_overlap_no_interval");
    return;
  }
  // 1 − δ², without cancellation
  const DoubleDouble oneMinusSquare =
      exactQuotient(pairs - excess, pairs) * exactQuotient(pairs + excess, pairs);
  const DoubleDouble least = oneMinusSquare / exactQuotient(pairs - 1, 1);
  const bool isLess = (variance - least).high < 0.0;
  result.interval =
      fengCliffInterval(exactQuotient(excess, pairs), oneMinusSquare, isLess ? least : variance, z);
}

constexpr std::size_t kMostDifferences = 4000;  // eight million averages

std::vector<double> walshAverages(std::span<const double> differences) {
  std::vector<double> averages;
  averages.reserve(differences.size() * (differences.size() + 1) / 2);
  for (std::size_t i = 0; i < differences.size(); ++i) {
    for (std::size_t j = i; j < differences.size(); ++j) {
      averages.push_back(std::midpoint(differences[i], differences[j]));
    }
  }
  std::ranges::sort(averages);
  return averages;
}

}  // namespace

CliffDelta cliffDelta(
    std::span<const double> group1, std::span<const double> group2, double level) {
  return cliffDelta(tiedGroupsOf(group1, group2), level);
}

CliffDelta cliffDelta(const TiedGroups& groups, double level) {
  const double z = normalTwoSidedQuantile(level);
  CliffDelta result;
  result.n1 = groups.n1;
  result.n2 = groups.n2;
  if (groups.isEmpty() || groups.areTooLargeForExactRanks()) {
    result.reason = groups.isEmpty() ? reason("a_group_is_empty") : reason("groups_too_large");
    return result;
  }
  const Placements placements = placementsOf(groups);
  const auto pairs = static_cast<Int128>(groups.n1) * static_cast<Int128>(groups.n2);
  result.delta = exactQuotient(placements.sum1 - pairs, pairs).high;
  if (groups.n1 < 2 || groups.n2 < 2) {
    result.reason = reason("two_values_needed");
    return result;
  }
  addVarianceAndInterval(result, groups, placements, z);
  return result;
}

HodgesLehmannResult hodgesLehmann(std::span<const double> differences) {
  if (!std::ranges::all_of(differences, [](double number) { return std::isfinite(number); })) {
    throw std::invalid_argument("a difference is infinite or no number");
  }
  HodgesLehmannResult result;
  result.n = differences.size();
  if (differences.empty() || differences.size() > kMostDifferences) {
    result.reason = differences.empty() ? reason("no_differences") : reason("too_many_averages");
    return result;
  }
  const auto averages = walshAverages(differences);
  const std::size_t half = averages.size() / 2;
  result.estimate =
      averages.size() % 2 == 1 ? averages[half] : std::midpoint(averages[half - 1], averages[half]);
  return result;
}

}  // namespace analysis
