#pragma once

#include <vector>

#include "haptics/recordings/curve_point.h"

namespace haptics::recordings {

/// A force over a travel, fit to be looked up: the travel rises strictly from node to node, and
/// every number is finite. Straight between the nodes (eq. (2) of the punch paper).
class ForceCurve {
 public:
  /// @throws std::invalid_argument  if there are fewer than two nodes, a travel does not lie above
  ///     the one before it, or a number is not finite.
  explicit ForceCurve(std::vector<CurvePoint> nodes);

  const std::vector<CurvePoint>& nodes() const noexcept { return nodes_; }
  double start() const noexcept { return nodes_.front().travel; }  ///< [travel units]
  double end() const noexcept { return nodes_.back().travel; }     ///< [travel units]

  /// The force [N] at a travel; before the first and after the last node that node's.
  double forceAt(double travel) const noexcept;

  /// max |Δf / Δx| over neighbouring nodes [N/travel unit].
  double largestSlope() const noexcept;

  friend bool operator==(const ForceCurve&, const ForceCurve&) = default;

 private:
  std::vector<CurvePoint> nodes_;
};

}  // namespace haptics::recordings
