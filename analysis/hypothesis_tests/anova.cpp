#include "analysis/hypothesis_tests/anova.h"

#include <algorithm>
#include <limits>

#include "analysis/data/two_way_layout.h"
#include "analysis/numerics/distributions.h"

namespace analysis {
namespace {

/// Sums of squares between and within groups [4^exponent].
struct Squares {
  int exponent = 0;
  DoubleDouble between;
  DoubleDouble within;
};

Squares squaresOf(std::span<const Moments> groups, double n) {
  Squares squares{
      .exponent = std::ranges::max(groups, {}, &Moments::exponent).exponent,
      .between = {},
      .within = {}};
  const auto inCommonUnits = [&](const Moments& group) {
    return scaled(group.mean, group.exponent - squares.exponent);
  };
  const DoubleDouble pivot = inCommonUnits(groups.front());
  DoubleDouble sum;
  for (const auto& group : groups) {
    sum = sum + (inCommonUnits(group) - pivot) * static_cast<double>(group.n);
  }
  const DoubleDouble shift = sum / n;
  for (const auto& group : groups) {
    const DoubleDouble effect = inCommonUnits(group) - pivot - shift;
    squares.between = squares.between + effect * effect * static_cast<double>(group.n);
    squares.within =
        squares.within + scaled(group.variance, 2 * (group.exponent - squares.exponent)) *
                             static_cast<double>(group.n - 1);
  }
  return squares;
}

Reason whyImpossible(std::span<const Moments> groups, std::uint64_t n) {
  if (groups.size() < 2) return reason("two_groups_needed");
  if (std::ranges::any_of(groups, [](const Moments& group) { return group.n == 0; })) {
    return reason("a_group_is_empty");
  }
  if (n == groups.size()) return reason("one_value_each");
  return {};
}

void addTest(OneWayAnovaResult& result, const Squares& squares) {
  const double df1 = *result.degreesOfFreedom1;
  const double df2 = *result.degreesOfFreedom2;
  const double f = (squares.between / df1 / (squares.within / df2)).high;
  const FisherDistribution distribution(df1, df2);
  result.f = f;
  result.p = distribution.upperP(f);
  result.log10P = distribution.log10UpperP(f);
}

}  // namespace

OneWayAnovaResult oneWayAnova(std::span<const std::vector<double>> groups) {
  std::vector<Moments> moments;
  moments.reserve(groups.size());
  for (const auto& values : groups) moments.push_back(momentsOf(values));
  return oneWayAnova(moments);
}

OneWayAnovaResult oneWayAnova(std::span<const Moments> groups) {
  OneWayAnovaResult result;
  result.groups = groups.size();
  for (const auto& group : groups) result.n += group.n;
  result.reason = whyImpossible(groups, result.n);
  if (!result.reason.empty()) return result;

  const auto n = static_cast<double>(result.n);
  const auto k = static_cast<double>(groups.size());
  const Squares squares = squaresOf(groups, n);
  const DoubleDouble all = squares.between + squares.within;
  result.squaresBetween = toDouble(squares.between, 2 * squares.exponent);
  result.squaresWithin = toDouble(squares.within, 2 * squares.exponent);
  result.residualStandardDeviation =
      toDouble(squareRoot(squares.within / (n - k)), squares.exponent);
  result.degreesOfFreedom1 = k - 1.0;
  result.degreesOfFreedom2 = n - k;
  if (!all.isZero()) result.rSquared = (squares.between / all).high;
  if (!squares.within.isZero()) {
    addTest(result, squares);
    if (!result.squaresBetween || !result.squaresWithin) {
      result.reason = reason("sum_beyond_double");
    }
  } else if (all.isZero()) {
    result.reason = reason("all_values_same");
  } else {
    result.f = std::numeric_limits<double>::infinity();
    result.reason = reason("constant_groups_differ");
  }
  return result;
}

namespace {

/// Greenhouse and Geisser's ε from the residuals e of the layout. The covariance matrix S is eᵀe
/// times a constant, which cancels in ε.
double greenhouseGeisser(const TwoWayLayout& layout) {
  const std::size_t k = layout.columns;
  DoubleDouble traceOfSquare;
  for (std::size_t j = 0; j < k; ++j) {
    for (std::size_t l = 0; l < k; ++l) {
      DoubleDouble covariance;
      for (std::size_t i = 0; i < layout.rows; ++i) {
        covariance = covariance + layout.residuals[i * k + j] * layout.residuals[i * k + l];
      }
      traceOfSquare = traceOfSquare + covariance * covariance;
    }
  }
  const DoubleDouble trace = layout.residualSquares;
  return (trace * trace / traceOfSquare / static_cast<double>(k - 1)).high;
}

void addTests(RepeatedMeasuresResult& result, const TwoWayLayout& layout) {
  const double f = (layout.columnMeanSquare() / layout.residualMeanSquare()).high;
  const double df1 = *result.degreesOfFreedom1;
  const double df2 = *result.degreesOfFreedom2;
  const double epsilon = greenhouseGeisser(layout);
  const FisherDistribution distribution(df1, df2);
  const FisherDistribution corrected(epsilon * df1, epsilon * df2);

  result.f = f;
  result.p = distribution.upperP(f);
  result.log10P = distribution.log10UpperP(f);
  result.greenhouseGeisser = epsilon;
  result.pGreenhouseGeisser = corrected.upperP(f);
}

}  // namespace

RepeatedMeasuresResult repeatedMeasuresAnova(std::span<const std::vector<double>> table) {
  const TwoWayLayout layout = twoWayLayout(table);
  RepeatedMeasuresResult result;
  result.participants = layout.rows;
  result.conditions = layout.columns;
  if (layout.rows < 2) {
    result.reason = reason("two_participants_needed");
    return result;
  }
  if (layout.columns < 2) {
    result.reason = reason("two_conditions_needed");
    return result;
  }

  const DoubleDouble both = layout.columnSquares + layout.residualSquares;
  result.degreesOfFreedom1 = static_cast<double>(layout.columns - 1);
  result.degreesOfFreedom2 = static_cast<double>((layout.columns - 1) * (layout.rows - 1));
  if (!both.isZero()) result.partialEtaSquared = (layout.columnSquares / both).high;
  if (!layout.residualSquares.isZero()) {
    addTests(result, layout);
  } else if (both.isZero()) {
    result.reason = reason("conditions_not_told_apart");
  } else {
    result.f = std::numeric_limits<double>::infinity();
    result.reason = reason("same_change");
  }
  return result;
}

}  // namespace analysis
