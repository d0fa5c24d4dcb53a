#pragma once

#include <span>
#include <vector>

#include "haptics/models/hermite_curve.h"
#include "haptics/reaming/material/sampled_curve.h"

namespace haptics::reaming {

/// Slopes at the nodes of a curve with which its cubic Hermite spline does not overshoot: weighted
/// harmonic means of the secants, one-sided at the ends (Fritsch & Butland 1984, "PCHIP").
///
/// @param positions  two or more, strictly increasing; as many @p values.
std::vector<double> monotoneSlopes(
    const std::vector<double>& positions, const std::vector<double>& values);

/// How the slopes at the nodes of a piecewise cubic are computed.
enum class SplineKind {
  HermiteDataSlope,  ///< slopes of the data: the paper's cubic Hermite spline
  Pchip,             ///< monotone: weighted harmonic means (Fritsch & Butland 1984)
  Makima,            ///< Akima's weighted means, with MATLAB's modification for flat data
  NaturalCubic,      ///< continuous second derivative, 0 at the ends: the paper's cubic spline
  Linear,            ///< no cubic: linear pieces
};

/// Slopes of sampled data, from the parabola through a sample and its neighbours; one-sided at the
/// ends.
std::vector<double> dataSlopes(const SampledCurve& curve);

/// A piecewise cubic or linear curve.
struct Spline {
  /// For Linear the slope is that of the piece after the node.
  std::vector<models::HermiteNode<double>> nodes;
  std::vector<models::CubicSegment<double>> segments;  ///< between the nodes

  /// The value at @p x; constant beyond the ends.
  double at(double x) const noexcept;
};

/// The cubic spline through two or more nodes with given slopes.
Spline splineOf(std::vector<models::HermiteNode<double>> nodes);

/// The spline through the samples @p nodes (two or more increasing indices) of a curve.
///
/// @param slopes  of every sample of the curve; used by HermiteDataSlope only.
Spline splineThrough(
    const SampledCurve& curve,
    std::span<const double> slopes,
    std::span<const std::size_t> nodes,
    SplineKind kind);

/// Deviation of a spline from the data, by several measures.
struct ApproximationError {
  double published = 0.0;          ///< max |v − v̂|/|v| over v ≠ 0: the paper's e_a
  double publishedPosition = 0.0;  ///< position of that maximum [unit of x]
  double floored = 0.0;            ///< max |v − v̂| / max(|v|, floor)
  double flooredPosition = 0.0;
  double largest = 0.0;  ///< max |v − v̂| [unit of y]
  double rms = 0.0;      ///< [unit of y]
  double rSquared = 0.0;
};

/// @param floor  least denominator of ApproximationError::floored [unit of y], > 0.
ApproximationError errorOf(const SampledCurve& curve, const Spline& spline, double floor);

}  // namespace haptics::reaming
