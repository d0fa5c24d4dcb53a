#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "haptics/reaming/material/piecewise.h"
#include "haptics/reaming/material/sampled_curve.h"

namespace haptics::reaming {

/// Which samples of a curve become nodes of its spline.
enum class NodeRule {
  Greedy,        ///< split the piece with the largest error at that place, until the error is met
  PaperLiteral,  ///< every sample whose |f″| is above a threshold, which falls until it is met
  Thinned,       ///< of each run of such samples its middle
  Optimal,       ///< as few as there can be, by dynamic programming over at most 2,001 samples
};

/// What nodes are chosen for. The error is that of the spline of this kind through them:
/// max |v − v̂| / max(|v|, floor). PaperLiteral takes the paper's own e_a instead,
/// max |v − v̂| / |v| over v ≠ 0; it does not depend on the floor.
struct NodeWish {
  NodeRule rule = NodeRule::Greedy;
  SplineKind kind = SplineKind::HermiteDataSlope;
  double error = 0.05;  ///< the largest that is wanted, as a share, > 0
  double floor = 10.0;  ///< [unit of y], > 0
};

/// Nodes as indices into the curve, rising, with both ends.
struct NodeChoice {
  std::vector<std::size_t> nodes;
  double error = 0.0;  ///< of the spline through them, by the measure of the wish
  bool isMet = true;   ///< the error is at most what was wanted
};

/// Whether a piece of such a spline depends on its two nodes alone.
constexpr bool isLocal(SplineKind kind) noexcept {
  return kind == SplineKind::HermiteDataSlope || kind == SplineKind::Linear;
}

/// Why no nodes can be chosen so; std::nullopt if they can. Optimal needs a local kind of spline.
std::optional<std::string> problemOf(const NodeWish& wish);

/// Nodes until the error is met. Greedy always reaches it; Thinned may not, and then reports it.
///
/// @param wish  without a problem.
NodeChoice chooseNodes(const SampledCurve& curve, const NodeWish& wish);

/// As many nodes as were asked for, at which the largest error of the spline of this kind is least:
/// of a local kind by dynamic programming over 400 places, then every node moved sample by sample
/// while that helps; of the others by the same moves from several starts. The rule is not looked
/// at.
///
/// @param count  from 2 to the size of the curve.
NodeChoice chooseNodes(const SampledCurve& curve, std::size_t count, const NodeWish& wish);

/// The largest error of a kind of spline through @p nodes, by the measure of a wish.
double largestError(
    const SampledCurve& curve, std::span<const std::size_t> nodes, const NodeWish& wish);

/// How far splines through some samples of a curve are off.
class SplineDeviation {
 public:
  struct Worst {
    double error = 0.0;  ///< by the measure of the wish
    std::size_t at = 0;  ///< the sample
  };

  /// @param curve  must outlive this object.
  SplineDeviation(const SampledCurve& curve, const NodeWish& wish);

  std::size_t size() const noexcept { return curve_.size(); }
  const SampledCurve& curve() const noexcept { return curve_; }
  const std::vector<double>& slopes() const noexcept { return slopes_; }

  /// Of the piece between two samples of a local kind; stops as soon as it exceeds @p enough.
  Worst between(
      std::size_t from,
      std::size_t to,
      double enough = std::numeric_limits<double>::infinity()) const;

  /// Of the whole spline through @p nodes; stops as soon as it exceeds @p enough.
  Worst through(
      std::span<const std::size_t> nodes,
      double enough = std::numeric_limits<double>::infinity()) const;

 private:
  Worst of(
      const models::CubicSegment<double>& piece,
      std::size_t from,
      std::size_t to,
      double enough) const;

  const SampledCurve& curve_;
  NodeWish wish_;
  std::vector<double> slopes_;
};

/// Nodes of the least largest error, as many as asked for: chooseNodes().
std::vector<std::size_t> nodesOfLeastError(
    const SplineDeviation& error, std::size_t count, const NodeWish& wish);

/// One of the splines of a comparison.
struct ComparedSpline {
  SplineKind kind = SplineKind::NaturalCubic;
  Spline spline;
  ApproximationError error;
  /// |e_a| where the first spline of the comparison is worst, as published and with the floor: the
  /// paper's "at the same reamer displacement".
  double publishedThere = 0.0;
  double flooredThere = 0.0;
};

/// Splines through the same nodes of a curve.
struct SplineComparison {
  std::vector<std::size_t> nodes;  ///< indices into the curve
  std::vector<ComparedSpline> splines;
};

/// Fig. 7 of the reaming paper for any curve: the natural cubic and the cubic Hermite spline
/// through the same nodes.
///
/// @param nodes  indices into the curve, rising, two or more. @param floor  ApproximationError.
SplineComparison compareSplines(
    const SampledCurve& curve, std::vector<std::size_t> nodes, double floor);

}  // namespace haptics::reaming
