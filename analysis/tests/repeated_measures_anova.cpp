#include "analysis/tests/repeated_measures_anova.h"

#include <limits>

#include "analysis/data/two_way_layout.h"
#include "analysis/numerics/fisher_distribution.h"

namespace analysis {
namespace {

/// ε from the residuals e of the layout: S is eᵀe, but for a factor.
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
  const FisherDistribution law(df1, df2);
  const FisherDistribution corrected(epsilon * df1, epsilon * df2);

  result.f = f;
  result.p = law.upperP(f);
  result.log10P = law.log10UpperP(f);
  result.greenhouseGeisser = epsilon;
  result.pGreenhouseGeisser = corrected.upperP(f);
  result.log10PGreenhouseGeisser = corrected.log10UpperP(f);
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
