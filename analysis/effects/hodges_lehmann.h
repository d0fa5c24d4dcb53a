#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "analysis/data/reason.h"
#include "analysis/numerics/interval.h"

namespace analysis {

/// Where paired differences lie, by the signed rank test. What is missing has its reason.
struct HodgesLehmannResult {
  std::uint64_t n = 0;
  std::optional<double> estimate;
  std::optional<Interval> interval;  ///< both ends are Walsh averages and belong to it
  std::optional<double>
      confidence;  ///< of the interval without ties; not below the level asked for
  Reason reason;   ///< why something above is missing; empty if nothing is
};

/// Hodges & Lehmann's estimate (1963): the median of the Walsh averages (dᵢ + dⱼ)/2, i ≤ j.
///
/// The interval holds what the exact signed rank test would not reject: from the C-th smallest to
/// the C-th largest of the M = n(n + 1)/2 averages, with C the largest number for which
/// P(V < C) ≤ (1 − level)/2. Where even C = 1 is too many there is no such interval: for 0.95
/// below n = 6. Differences of zero count as any other. With ties the confidence is at least the
/// one told.
///
/// @throws std::invalid_argument  if a difference is infinite or no number, or for a level that is
///     not between 0 and 1.
HodgesLehmannResult hodgesLehmann(std::span<const double> differences, double level = 0.95);

}  // namespace analysis
