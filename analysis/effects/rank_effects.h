#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "analysis/data/ranks.h"
#include "analysis/data/reason.h"
#include "analysis/numerics/interval.h"

namespace analysis {

/// How much more often values of one group are larger than those of the other. What is not defined
/// is missing, with a reason.
struct CliffDelta {
  std::uint64_t n1 = 0;
  std::uint64_t n2 = 0;
  std::optional<double> delta;                     ///< −1 … 1
  std::optional<double> probabilityOfSuperiority;  ///< P(X > Y) + ½ P(X = Y) = (δ + 1)/2
  std::optional<double> variance;  ///< Cliff's unbiased one, of δ; it may come out negative
  std::optional<Interval> interval;
  Reason reason;  ///< why something above is missing; empty if nothing is
};

/// Cliff's δ (1993): P(X > Y) − P(X < Y) for X of group 1 and Y of group 2, with Feng & Cliff's
/// asymmetric interval (2004, J. Modern Applied Statistical Methods 3),
///
///     (δ − δ³ ± z s √((1 − δ²)² + z² s²)) / (1 − δ² + z² s²)
///
/// where s² is the unbiased variance, but not below (1 − δ²)/(n₁n₂ − 1), and z the normal quantile
/// of the level.
///
/// Variance and interval need two values in each group; groups that do not overlap have no
/// interval.
///
/// @throws std::invalid_argument  if a value is infinite or NaN, or for a level that is not between
///     0 and 1.
CliffDelta cliffDelta(
    std::span<const double> group1, std::span<const double> group2, double level = 0.95);
CliffDelta cliffDelta(const TiedGroups& groups, double level = 0.95);

/// The location of paired differences, by the signed rank test. What is missing has a reason.
struct HodgesLehmannResult {
  std::uint64_t n = 0;
  std::optional<double> estimate;
  std::optional<Interval> interval;  ///< both ends are Walsh averages and belong to it
  std::optional<double> confidence;  ///< of the interval without ties; not below the level
  Reason reason;                     ///< why something above is missing; empty if nothing is
};

/// Hodges & Lehmann's estimate (1963): the median of the Walsh averages (dᵢ + dⱼ)/2, i ≤ j.
///
/// The interval contains the values that the exact signed rank test would not reject: from the C-th
/// smallest to the C-th largest of the M = n(n + 1)/2 averages, with C the largest number for which
/// P(V < C) ≤ (1 − level)/2. Where even C = 1 is too many there is no such interval: for 0.95
/// below n = 6. Differences of zero count as any other. With ties the true confidence is at least
/// `confidence`.
///
/// @throws std::invalid_argument  if a difference is infinite or NaN, or for a level that is not
///     between 0 and 1.
HodgesLehmannResult hodgesLehmann(std::span<const double> differences, double level = 0.95);

}  // namespace analysis
