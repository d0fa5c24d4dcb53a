#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/data/reason.h"
#include "analysis/numerics/interval.h"

namespace analysis {

/// Cronbach's α, the internal consistency of the items of a scale, and its confidence interval.
struct CronbachAlpha {
  std::size_t respondents = 0;
  std::size_t items = 0;
  double level = 0.95;               ///< of the interval
  std::optional<double> value;       ///< at most 1; negative if items correlate negatively
  std::optional<Interval> interval;  ///< Feldt's
  Reason reason;  ///< why something above is missing, or what a negative value says; else empty
};

/// Cronbach's α (1951) of the sum of k items, with Feldt's interval (1965):
///
///     α = k/(k − 1) · (1 − Σ sᵢ² / s²) = 1 − MS_residual / MS_respondents
///     limits: 1 − (1 − α) F,   F the quantiles with n − 1 and (n − 1)(k − 1) degrees of freedom
///
/// @param answers  one respondent per row, one item per column, reverse-keyed items already
///     reversed.
/// @throws std::invalid_argument  if a row has fewer or more values than the first, a value is
///     infinite or NaN, or for a level that is not between 0 and 1.
CronbachAlpha cronbachAlpha(std::span<const std::vector<double>> answers, double level = 0.95);

/// McDonald's ω: the share of the variance of a sum of items that is due to their common factor.
struct OmegaTotal {
  std::size_t respondents = 0;
  std::size_t items = 0;
  std::optional<double> value;   ///< in 0 … 1
  std::vector<double> loadings;  ///< of the standardised items
  /// Whether the error variance of an item is estimated as 0; ω is then only a rough indication.
  bool isImproper = false;
  Reason reason;  ///< why something above is missing; empty if nothing is
};

/// McDonald's ω total (1999) of the sum of the unstandardised items, in a model with one common
/// factor:
///
///     ω = (Σ sᵢ λᵢ)² / ((Σ sᵢ λᵢ)² + Σ sᵢ² (1 − λᵢ²))
///
/// with sᵢ the standard deviation of an item and λᵢ its loading; see fitOneFactor() for the
/// estimator. Equals α if all loadings are equal. Needs at least three items, none of them
/// constant.
///
/// @param answers  one respondent per row, one item per column, reverse-keyed items already
///     reversed.
/// @throws std::invalid_argument  if a row has fewer or more values than the first, or a value is
///     infinite or NaN.
OmegaTotal omegaTotal(std::span<const std::vector<double>> answers);

/// The loadings of several items on one common factor.
struct OneFactorModel {
  std::vector<double> loadings;  ///< of the standardised items, −1 … 1; their sum is not negative
  bool isImproper = false;   ///< a loading is ±1 (Heywood case): the item has no error variance
  bool hasConverged = true;  ///< false if the loadings still changed in the last step
};

/// The least-squares loadings λ of the correlations r of the items (minres, Harman & Jones 1966):
///
///     minimise Σ over i < j of (rᵢⱼ − λᵢ λⱼ)²,  with |λᵢ| ≤ 1 (Harman & Fukuda 1966)
///
/// Coordinate descent from the first principal component: sets each loading in turn to its best
/// value, λᵢ = Σ rᵢⱼ λⱼ / Σ λⱼ² over j ≠ i, until none changes. Works also for few respondents,
/// where the correlation matrix is singular and maximum likelihood fails.
///
/// @param correlations  a symmetric matrix with ones on its diagonal.
/// @throws std::invalid_argument  for fewer than three items, which do not determine the loadings;
///     for a matrix that is not square or has entries outside −1 … 1.
OneFactorModel fitOneFactor(std::span<const std::vector<double>> correlations);

}  // namespace analysis
