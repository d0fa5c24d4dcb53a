#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "haptics/reaming/material/sampled_curve.h"
#include "haptics/reaming/material/spline.h"

namespace haptics::reaming {

/// Which samples of a curve become nodes of its spline.
enum class NodeRule {
  Greedy,  ///< split the piece with the largest error, at the sample of that error, until the error
           ///< is met
  PaperLiteral,  ///< every sample whose |f″| exceeds a threshold, which falls until the error is
                 ///< met
  Thinned,       ///< the middle of each run of samples that PaperLiteral chooses
  Optimal,       ///< as few nodes as possible, by dynamic programming over at most 2,001 samples
};

/// How nodes are to be chosen. The error of the spline through them is max |v − v̂| / max(|v|,
/// floor); PaperLiteral uses the paper's e_a instead, max |v − v̂| / |v| over v ≠ 0, which does not
/// depend on the floor.
struct NodeCriterion {
  NodeRule rule = NodeRule::Greedy;
  SplineKind kind = SplineKind::HermiteDataSlope;
  double error = 0.05;  ///< largest allowed relative error, > 0
  double floor = 10.0;  ///< [unit of y], > 0
};

/// Nodes as increasing indices into the curve, including both ends.
struct NodeChoice {
  std::vector<std::size_t> nodes;
  double error = 0.0;  ///< of the spline through them, as NodeCriterion defines it
  bool isMet = true;   ///< the error is at most NodeCriterion::error
};

/// Whether a piece of a spline of this kind depends only on the two nodes at its ends.
constexpr bool isLocal(SplineKind kind) noexcept {
  return kind == SplineKind::HermiteDataSlope || kind == SplineKind::Linear;
}

/// Why @p nodeCriterion is not valid; std::nullopt if it is valid. Optimal needs a local kind of
/// spline.
std::optional<std::string> problemOf(const NodeCriterion& nodeCriterion);

/// Chooses nodes until the error is met. Greedy always meets it; Thinned may not
/// (NodeChoice::isMet).
///
/// @param nodeCriterion  valid, see problemOf().
NodeChoice chooseNodes(const SampledCurve& curve, const NodeCriterion& nodeCriterion);

/// Chooses @p count nodes that minimise the largest error of the spline: for a local kind by
/// dynamic programming over 400 samples, then local moves of all nodes; for the others by
/// differential evolution. NodeCriterion::rule is ignored.
///
/// @param count  from 2 to the size of the curve.
NodeChoice chooseNodes(
    const SampledCurve& curve, std::size_t count, const NodeCriterion& nodeCriterion);

/// Computes errors of splines through some samples of a curve.
class SplineDeviation {
 public:
  struct Worst {
    double error = 0.0;  ///< as NodeCriterion defines it
    std::size_t at = 0;  ///< index of the sample
  };

  /// @param curve  must outlive this object.
  SplineDeviation(const SampledCurve& curve, const NodeCriterion& nodeCriterion);

  std::size_t size() const noexcept { return curve_.size(); }
  const SampledCurve& curve() const noexcept { return curve_; }
  const std::vector<double>& slopes() const noexcept { return slopes_; }

  /// Largest error of the piece between two samples, for a local kind; stops as soon as the error
  /// exceeds @p errorLimit.
  Worst worstOfPiece(
      std::size_t from,
      std::size_t to,
      double errorLimit = std::numeric_limits<double>::infinity()) const;

  /// Largest error of the whole spline through @p nodes; stops as soon as the error exceeds
  /// @p errorLimit.
  Worst worstOfSpline(
      std::span<const std::size_t> nodes,
      double errorLimit = std::numeric_limits<double>::infinity()) const;

 private:
  Worst worstOfCubic(
      const models::CubicSegment<double>& piece,
      std::size_t from,
      std::size_t to,
      double errorLimit) const;

  const SampledCurve& curve_;
  NodeCriterion criterion_;
  std::vector<double> slopes_;
};

/// The search of chooseNodes() for a given number of nodes.
std::vector<std::size_t> nodesOfLeastError(
    const SplineDeviation& error, std::size_t count, const NodeCriterion& nodeCriterion);

/// A spline of a comparison.
struct ComparedSpline {
  SplineKind kind = SplineKind::NaturalCubic;
  Spline spline;
  ApproximationError error;
  /// Relative errors where the first spline of the comparison is worst (the paper's "at the same
  /// reamer displacement"): as published, and with the floor.
  double publishedErrorAtWorst = 0.0;
  double flooredErrorAtWorst = 0.0;
};

/// Splines through the same nodes of a curve.
struct SplineComparison {
  std::vector<std::size_t> nodes;  ///< indices into the curve
  std::vector<ComparedSpline> splines;
};

/// Compares the natural cubic and the cubic Hermite spline through the same nodes, as Fig. 7 of the
/// reaming paper.
///
/// @param nodes  two or more increasing indices into the curve. @param floor see errorOf().
SplineComparison compareSplines(
    const SampledCurve& curve, std::vector<std::size_t> nodes, double floor);

}  // namespace haptics::reaming
