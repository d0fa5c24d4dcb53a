#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/data/moments.h"
#include "analysis/data/reason.h"

namespace analysis {

/// The result of a one-way analysis of variance.
struct OneWayAnovaResult {
  std::size_t groups = 0;
  std::uint64_t n = 0;  ///< number of values in all groups

  std::optional<double> squaresBetween;     ///< sum of squares; std::nullopt beyond a double
  std::optional<double> squaresWithin;      ///< sum of squares; std::nullopt beyond a double
  std::optional<double> f;                  ///< +infinity for constant groups that differ
  std::optional<double> degreesOfFreedom1;  ///< k − 1
  std::optional<double> degreesOfFreedom2;  ///< n − k
  std::optional<double> p;
  std::optional<double> log10P;  ///< defined even if p is too small for a double
  /// Sum of squares between groups / total sum of squares, 0 … 1; η².
  std::optional<double> rSquared;
  std::optional<double> residualStandardDeviation;  ///< standard deviation within groups, pooled

  Reason reason;  ///< why something above is missing; empty if nothing is
};

/// One-way analysis of variance: do k groups differ in their mean, if all have the same variance?
///
///     F = (Σ nⱼ (mⱼ − m)² / (k − 1)) / (Σ (nⱼ − 1) sⱼ² / (n − k))
///
/// Means and squares are computed with 31 digits, so that a large offset costs no accuracy.
///
/// Not defined for fewer than two groups, for an empty group, if no group has two values, or if all
/// groups are constant.
///
/// @throws std::invalid_argument  if a value is infinite or NaN.
OneWayAnovaResult oneWayAnova(std::span<const std::vector<double>> groups);
OneWayAnovaResult oneWayAnova(std::span<const Moments> groups);

/// The result of a repeated-measures analysis of variance with one factor.
struct RepeatedMeasuresResult {
  std::size_t participants = 0;
  std::size_t conditions = 0;

  std::optional<double> f;  ///< +infinity if all participants change in the same way
  std::optional<double> degreesOfFreedom1;  ///< k − 1
  std::optional<double> degreesOfFreedom2;  ///< (k − 1)(n − 1)
  std::optional<double> p;                  ///< valid if the conditions satisfy sphericity
  std::optional<double> log10P;             ///< defined even if p is too small for a double
  std::optional<double> partialEtaSquared;  ///< in 0 … 1

  std::optional<double> greenhouseGeisser;  ///< ε, from 1/(k − 1) to 1; 1 for spherical conditions
  std::optional<double> pGreenhouseGeisser;  ///< with both degrees of freedom times ε

  Reason reason;  ///< why something above is missing; empty if nothing is
};

/// Repeated-measures analysis of variance: do k conditions differ in their mean, if each of n
/// participants took part in all conditions?
///
///     F = (SS_conditions / (k − 1)) / (SS_residual / ((k − 1)(n − 1)))
///     partial η² = SS_conditions / (SS_conditions + SS_residual)
///     ε = (tr S)² / ((k − 1) tr S²),   S the covariance of the conditions, centred both ways
///
/// ε after Greenhouse & Geisser 1959; it does not depend on F, and the p value corrected by it is
/// valid whether or not the conditions are spherical. With two conditions, F = t² of the paired
/// test.
///
/// @param table  one participant a row, one condition a column.
/// @throws std::invalid_argument  if a row has fewer or more values than the first, or a value is
///     infinite or NaN.
RepeatedMeasuresResult repeatedMeasuresAnova(std::span<const std::vector<double>> table);

}  // namespace analysis
