#pragma once

namespace haptics::recordings {

/// A force at a place on the way of a tool.
struct CurvePoint {
  double travel = 0.0;  ///< [travel units]
  double force = 0.0;   ///< [N]

  friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

}  // namespace haptics::recordings
