#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace haptics::recordings {

/// A force at a place on the way of a tool.
struct CurvePoint {
  double travel = 0.0;  ///< [travel units]
  double force = 0.0;   ///< [N]

  friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

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

/// A curve made of samples whose travel did not only rise.
struct MonotoneCurve {
  ForceCurve curve;
  std::size_t samples = 0;  ///< that went in
  std::size_t merged = 0;   ///< fewer nodes than samples: all that a mean took the place of
};

/// Makes the travel of a closing hand rise strictly, and leaves alone what already does.
///
/// Wherever the travel falls or stays, neighbouring samples are merged into their mean – of
/// travel and of force – and go on being merged with what lies before them until the means rise:
/// pooling adjacent violators, which yields that rising sequence which is nearest to the travel in
/// least squares. No sample is discarded; samples of a hand that trembles about one place become
/// one node there. Travels nearer than 1e-6 units count as the same. O(n).
///
/// @param samples  in the order of time.
/// @throws std::invalid_argument  if fewer than two nodes remain, or a number is not finite.
MonotoneCurve monotoneCurve(std::span<const CurvePoint> samples);

/// A curve that nowhere rises or falls faster than allowed, and what that changed.
struct SlopeLimited {
  ForceCurve curve;
  double largestChange = 0.0;    ///< of a node's force [N]
  double largestChangeAt = 0.0;  ///< its travel [travel units]
};

/// Limits the slope of a curve to K, changing it as little as it can on both sides.
///
/// Between the largest curve of slope K that lies nowhere above f and the smallest that lies
/// nowhere below it (the envelopes of McShane and Whitney) it takes the middle:
///
///     g(x) = ½ [ min_y (f(y) + K |x − y|) + max_y (f(y) − K |x − y|) ]
///
/// No node-to-node slope of g is larger than K (to rounding), no such curve has a smaller largest
/// change, and a curve that was gentle enough stays what it is. Two passes per envelope, O(n).
///
/// @param maxSlope  K [N/travel unit].
/// @throws std::invalid_argument  if K is not positive and finite.
SlopeLimited limitSlope(const ForceCurve& curve, double maxSlope);

/// The mean of several curves, where all of them are, and how far they lie apart.
struct MeanCurve {
  ForceCurve curve;               ///< kNodes nodes, evenly spaced
  std::vector<double> deviation;  ///< standard deviation of the forces at each node, n − 1 [N]

  static constexpr std::size_t kNodes = 201;
};

/// Nothing if there are no curves, or no travel that all of them share.
std::optional<MeanCurve> meanCurve(std::span<const ForceCurve> curves);

/// Which of the curves is least far from their mean: the index (from 0) of the smallest
/// root-mean-square difference over the mean's nodes, the first of equals. Nothing if there is no
/// mean.
std::optional<std::size_t> mostTypical(std::span<const ForceCurve> curves);

}  // namespace haptics::recordings
