#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/data/moments.h"
#include "analysis/data/reason.h"

namespace analysis {

/// What an analysis of variance says about several groups.
struct OneWayAnovaResult {
  std::size_t groups = 0;
  std::uint64_t n = 0;  ///< of all groups together

  std::optional<double> squaresBetween;     ///< sum of squares; nothing beyond a double
  std::optional<double> squaresWithin;      ///< sum of squares; nothing beyond a double
  std::optional<double> f;                  ///< +infinity for constant groups that differ
  std::optional<double> degreesOfFreedom1;  ///< k − 1
  std::optional<double> degreesOfFreedom2;  ///< n − k
  std::optional<double> p;
  std::optional<double> log10P;             ///< also where p is too small for a double
  std::optional<double> rSquared;           ///< share of the groups in all squares, 0 … 1; η²
  std::optional<double> residualDeviation;  ///< standard deviation within groups, pooled

  Reason reason;  ///< why something above is missing; empty if nothing is
};

/// One-way analysis of variance: do k groups differ in their mean, if all have the same variance?
///
///     F = (Σ nⱼ (mⱼ − m)² / (k − 1)) / (Σ (nⱼ − 1) sⱼ² / (n − k))
///
/// Means and squares are kept with 31 digits: a large offset costs nothing.
///
/// Not defined for fewer than two groups, for an empty group, where no group has two values, or
/// where all groups are constant.
///
/// @throws std::invalid_argument  if a value is infinite or NaN.
OneWayAnovaResult oneWayAnova(std::span<const std::vector<double>> groups);
OneWayAnovaResult oneWayAnova(std::span<const Moments> groups);

}  // namespace analysis
