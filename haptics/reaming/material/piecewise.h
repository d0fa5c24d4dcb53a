#pragma once

#include <span>
#include <vector>

#include "haptics/models/hermite_curve.h"
#include "haptics/reaming/material/sampled_curve.h"

namespace haptics::reaming {

/// Slopes at the nodes of a curve that keep its cubic Hermite spline from overshooting: weighted
/// harmonic means inside, one-sided at the ends (Fritsch & Butland 1984, "PCHIP").
///
/// @param positions  two or more, rising strictly; as many values.
std::vector<double> monotoneSlopes(
    const std::vector<double>& positions, const std::vector<double>& values);

/// How the slopes at the nodes of a piecewise cubic are come by.
enum class SplineKind {
  HermiteDataSlope,  ///< the slopes of the data: the paper's cubic Hermite spline
  Pchip,             ///< weighted harmonic means that keep it monotone (Fritsch & Butland 1984)
  Makima,            ///< Akima's weighted means, with MATLAB's modification for flat data
  NaturalCubic,      ///< second derivatives that join, none at the ends: the paper's cubic spline
  Linear,            ///< none: straight
};

/// Slopes of sampled data: of the parabola through a sample and its neighbours; one-sided at the
/// ends.
std::vector<double> dataSlopes(const SampledCurve& curve);

/// A piecewise cubic, or straight lines.
struct Spline {
  std::vector<models::HermiteNode<double>> nodes;      ///< slopes of Linear: of the piece after it
  std::vector<models::CubicSegment<double>> segments;  ///< between them

  /// Beyond its ends the value there.
  double at(double x) const noexcept;
};

/// The cubics between nodes with given slopes, two or more.
Spline splineOf(std::vector<models::HermiteNode<double>> nodes);

/// Through the samples @p nodes (indices, rising, two or more) of a curve.
///
/// @param slopes  of every sample of the curve; only HermiteDataSlope looks at them.
Spline splineThrough(
    const SampledCurve& curve,
    std::span<const double> slopes,
    std::span<const std::size_t> nodes,
    SplineKind kind);

/// How far a spline is from the data, in every way that it is asked.
struct ApproximationError {
  double published = 0.0;    ///< max |v − v̂|/|v| over v ≠ 0: the paper's e_a, as a share
  double publishedAt = 0.0;  ///< where [unit of x]
  double floored = 0.0;      ///< max |v − v̂| / max(|v|, floor), as a share
  double flooredAt = 0.0;
  double largest = 0.0;  ///< max |v − v̂| [unit of y]
  double rms = 0.0;      ///< [unit of y]
  double rSquared = 0.0;
};

/// @param floor  a smaller value does not make an error count for more [unit of y], > 0.
ApproximationError errorOf(const SampledCurve& curve, const Spline& spline, double floor);

}  // namespace haptics::reaming
