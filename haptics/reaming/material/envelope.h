#pragma once

#include <array>
#include <span>
#include <vector>

#include "haptics/reaming/material/node_choice.h"
#include "haptics/reaming/material/sampled_curve.h"

namespace haptics::reaming {

/// Three curves at the same abscissae, from soft to hard.
struct Envelope {
  SampledCurve minimum;
  SampledCurve average;  ///< the mean, or with SingleSample the middle specimen
  SampledCurve maximum;
};

/// How an envelope is computed from the specimens.
enum class EnvelopeRule {
  Pointwise,     ///< smallest, mean and largest value at each depth, as in the paper
  SingleSample,  ///< the curves of the softest, middle and hardest specimen, by mean force
};

/// A specimen's curve at depths 0, step, 2 step, … up to the end of its test.
struct SpecimenCurve {
  SampledCurve curve;  ///< over depth [m]
  double end = 0.0;    ///< depth at which the test ended [m]
  double last = 0.0;   ///< value at the end
  /// The test ended at its force limit, so the value beyond the end is at least `last`.
  bool isCensored = false;
};

/// An envelope over depth, with the number of specimens at each depth.
struct DepthEnvelope {
  Envelope curves;
  std::vector<int> measured;  ///< number of specimens whose test reaches the depth
  /// Number of specimens that ended at their force limit at a smaller depth, and count with their
  /// last value.
  std::vector<int> held;
};

/// Depth over which the weight of a specimen falls from 1 to 0 after its test has ended [m].
inline constexpr double kFadeOutDepth = 0.5e-3;

/// The envelope at the depths at which specimens were measured.
///
/// Up to the depth at which the first test ends, it is the statistic of all specimens. Beyond it
/// - a specimen whose test ended at its force limit keeps counting with the value at its end;
/// - a specimen that stalled, or reached the largest depth, counts with the value at its end and a
///   weight that falls from 1 to 0 over kFadeOutDepth. The mean is weighted; an extreme is the
///   expected extreme of a random sample that includes each specimen with a probability equal to
///   its weight;
/// - no curve falls because a specimen leaves: the fall is compensated by an offset, which is
///   reduced again only as far as the remaining specimens make the curve rise to a new maximum. So
///   a curve falls only if their forces fall.
///
/// With SingleSample, the specimens are those with the smallest, the middle and the largest mean up
/// to the first end; each is constant beyond its own end.
///
/// @param specimens  one or more, with the same step.
DepthEnvelope depthEnvelopeOf(std::span<const SpecimenCurve> specimens, EnvelopeRule rule);

/// At each depth, the envelope of only those specimens whose tests reach it, as in the reaming
/// paper. The curves have steps where a test ends.
DepthEnvelope envelopeOfRunningTests(std::span<const SpecimenCurve> specimens, EnvelopeRule rule);

/// The splines of an envelope: minimum, average, maximum.
using EnvelopeSplines = std::array<Spline, 3>;

/// Whether orderedSplines() supports @p nodeCriterion: kinds of spline whose slopes can be set per
/// node, and rules that can add nodes.
constexpr bool canBeOrdered(const NodeCriterion& nodeCriterion) noexcept {
  return (nodeCriterion.rule == NodeRule::Greedy || nodeCriterion.rule == NodeRule::Optimal) &&
         nodeCriterion.kind != SplineKind::NaturalCubic;
}

/// Splines of an envelope that never cross, so that a higher hardness is nowhere softer.
///
/// All three have the same nodes, the union of those that each needs. Slopes of neighbouring curves
/// that could make them cross are adjusted: with a gap g between the curves at a node and pieces of
/// length h after and before it, the difference of the slopes (upper − lower) is limited to −3g/h
/// (piece after) … 3g/h (piece before). Then the Bernstein coefficients of the difference of the
/// curves are not negative on any piece (Schmidt & Hess 1988, "Positivity of cubic polynomials on
/// intervals"). Nodes are added until each spline has the wanted error.
///
/// @param envelope  minimum <= average <= maximum everywhere. @param nodeCriterion valid by
/// canBeOrdered().
EnvelopeSplines orderedSplines(const Envelope& envelope, const NodeCriterion& nodeCriterion);

}  // namespace haptics::reaming
