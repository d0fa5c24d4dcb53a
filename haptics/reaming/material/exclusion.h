#pragma once

#include <string>

#include "haptics/reaming/material/series.h"

namespace haptics::reaming {

/// The reason why a series is not a valid measurement of reaming.
enum class ExclusionReason {
  None,
  Implausible,   ///< no numbers, too short, gaps, an axis that goes back
  FeedChanged,   ///< the reaming paper's (1): alterations of the feed rate during the test
  BrokeOut,      ///< (2): the acetabulum broke out of its resin embedding
  ReamedThrough  ///< (3): reamed completely after a displacement of 10 mm
};

struct Exclusion {
  ExclusionReason reason = ExclusionReason::None;
  std::string words;  ///< what happened, where, for people

  bool isExcluded() const noexcept { return reason != ExclusionReason::None; }
};

/// Looks for the paper's three reasons, and for data that cannot be a measurement at all.
///
/// - Feed: the slope of displacement over time, in twenty parts; one that differs from their median
///   by more than a third.
/// - Broke out: within half a second the force falls by more than half of what it had come to (20 N
///   or more), and never comes back to three quarters of it.
/// - Reamed through: beyond 10 mm the force stays below a tenth of its largest, to the end, for 1
/// mm
///   or more.
Exclusion exclusionOf(const Series& series);

}  // namespace haptics::reaming
