#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace haptics::recordings {

/// A force at a travel of the tool.
struct CurvePoint {
  double travel = 0.0;  ///< [travel units]
  double force = 0.0;   ///< [N]

  friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

/// Force over travel with linear interpolation (eq. (2) of the punch paper). Travels are strictly
/// increasing, and all numbers are finite.
class ForceCurve {
 public:
  /// @throws std::invalid_argument  if there are fewer than two nodes, travels are not strictly
  ///     increasing, or a number is not finite.
  explicit ForceCurve(std::vector<CurvePoint> nodes);

  const std::vector<CurvePoint>& nodes() const noexcept { return nodes_; }
  double start() const noexcept { return nodes_.front().travel; }  ///< [travel units]
  double end() const noexcept { return nodes_.back().travel; }     ///< [travel units]

  /// The force [N] at a travel [travel units]; constant beyond the first and the last node.
  double forceAt(double travel) const noexcept;

  /// max |Δf / Δx| over neighbouring nodes [N/travel unit].
  double largestSlope() const noexcept;

  friend bool operator==(const ForceCurve&, const ForceCurve&) = default;

 private:
  std::vector<CurvePoint> nodes_;
};

/// A curve made from samples whose travel was not monotone.
struct MonotoneCurve {
  ForceCurve curve;
  std::size_t samples = 0;  ///< number of samples used
  std::size_t merged = 0;   ///< number of samples − number of nodes
};

/// Makes the travel of a closing hand strictly increasing; does not change samples whose travel
/// already increases.
///
/// Where the travel does not increase, neighbouring samples are merged into their mean (of travel
/// and force), and merged further with earlier ones until the means increase: the
/// pool-adjacent-violators algorithm, which gives the least-squares increasing fit of the travel.
/// No sample is discarded; samples of a hand that trembles at one position become one node. Travels
/// that differ by less than 1e-6 units count as equal. O(n).
///
/// @param samples  in the order of time.
/// @throws std::invalid_argument  if fewer than two nodes remain, or a number is not finite.
MonotoneCurve monotoneCurve(std::span<const CurvePoint> samples);

/// A curve with limited slope, and the change by limiting.
struct SlopeLimited {
  ForceCurve curve;
  double largestChange = 0.0;    ///< largest change of a node's force [N]
  double largestChangeAt = 0.0;  ///< travel of that node [travel units]
};

/// Limits the slope of a curve to K with the smallest possible largest change.
///
/// The result is the mean of the largest curve of slope K that is nowhere above f and the smallest
/// that is nowhere below it (the envelopes of McShane and Whitney):
///
///     g(x) = ½ [ min_y (f(y) + K |x − y|) + max_y (f(y) − K |x − y|) ]
///
/// No slope between nodes of g exceeds K (except by rounding), and a curve that is within the limit
/// is not changed. Two passes per envelope, O(n).
///
/// @param maxSlope  K [N/travel unit].
/// @throws std::invalid_argument  if K is not positive and finite.
SlopeLimited limitSlope(const ForceCurve& curve, double maxSlope);

/// The mean and standard deviation of several curves over their common travel.
struct MeanCurve {
  ForceCurve curve;               ///< kNodes nodes, evenly spaced
  std::vector<double> deviation;  ///< standard deviation of the forces at each node [N]

  static constexpr std::size_t kNodes = 201;
};

/// The mean of @p curves; std::nullopt if there are no curves, or no travel that all of them
/// contain.
std::optional<MeanCurve> meanCurve(std::span<const ForceCurve> curves);

/// Index (from 0) of the curve with the smallest root-mean-square difference from the mean over the
/// mean's nodes; the first of equals. std::nullopt if there is no mean.
std::optional<std::size_t> indexOfMostTypical(std::span<const ForceCurve> curves);

}  // namespace haptics::recordings
