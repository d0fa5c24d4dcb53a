#pragma once

#include <array>
#include <span>
#include <vector>

#include "haptics/reaming/material/node_choice.h"
#include "haptics/reaming/material/sampled_curve.h"

namespace haptics::reaming {

/// Three curves on the same places, from soft to hard.
struct Envelope {
  SampledCurve minimum;
  SampledCurve average;  ///< the mean; of SingleSample the middle specimen
  SampledCurve maximum;
};

/// What an envelope is made of.
enum class EnvelopeRule {
  Pointwise,     ///< smallest, mean and largest value at each place, as in the paper
  SingleSample,  ///< the softest, the middle and the hardest specimen, by their mean force
};

/// A specimen's curve at depths 0, step, 2 step, … as far as it was measured.
struct SpecimenCurve {
  SampledCurve curve;  ///< over depth [m]
  double end = 0.0;    ///< where the test ended [m]
  double last = 0.0;   ///< the value there
  bool isCensored =
      false;  ///< the test ended at its force limit: the specimen was harder than that
};

/// An envelope over depth, and how many specimens it is made of.
struct DepthEnvelope {
  Envelope curves;
  std::vector<int> measured;  ///< at each place: whose tests go on
  std::vector<int> held;      ///< that have come to their force limit, and count with it
};

/// Over how much depth a specimen whose test has ended stops counting [m].
inline constexpr double kLeavesOver = 0.5e-3;

/// The envelope at the depths at which specimens were measured.
///
/// Up to the depth at which the first test ends, the statistic of all. Beyond it
/// - a specimen whose test ended at its force limit counts on with the value at its end;
/// - one that stalled, or came to the last depth, counts with the value at its end and a share that
///   falls from 1 to 0 over kLeavesOver. The mean is weighted by the shares, and an extreme is that
///   of a random sample in which each specimen is with the probability of its share;
/// - no curve falls because a specimen leaves: what it would fall by is added to it, and taken back
///   only as far as the specimens that are left make it rise above where it has been since. It
///   falls only where their forces do.
///
/// SingleSample has the specimens with the smallest, the middle and the largest mean up to the
/// first end, each level beyond its own.
///
/// @param specimens  one or more, at the same step.
DepthEnvelope depthEnvelopeOf(std::span<const SpecimenCurve> specimens, EnvelopeRule rule);

/// The envelope of those specimens whose tests reach a place, as the reaming paper has it: a test
/// that has ended is absent, and the curves step where one ends.
DepthEnvelope presentEnvelopeOf(std::span<const SpecimenCurve> specimens, EnvelopeRule rule);

/// The splines of an envelope from soft to hard.
using EnvelopeSplines = std::array<Spline, 3>;

/// Whether orderedSplines() does this: kinds with a slope of its own at each node, and nodes that
/// may be added.
constexpr bool canBeOrdered(const NodeWish& wish) noexcept {
  return (wish.rule == NodeRule::Greedy || wish.rule == NodeRule::Optimal) &&
         wish.kind != SplineKind::NaturalCubic;
}

/// Splines of curves that are in order everywhere, which are in order everywhere too, so that a
/// higher hardness is never softer.
///
/// All three have the same nodes, those that each needs. Where the slopes of two neighbours differ
/// so much that they could meet in between, they are brought together: with a gap g at a node and
/// pieces of h before and after it, the upper slope lies above the lower one by −3g/h (after) to
/// 3g/h (before). Then the Bernstein coefficients of their difference are not negative on any piece
/// (Schmidt & Hess 1988, "Positivity of cubic polynomials on intervals"). Nodes are added until
/// each spline has the error that was wanted.
///
/// @param envelope  in order at each place. @param wish  canBeOrdered().
EnvelopeSplines orderedSplines(const Envelope& envelope, const NodeWish& wish);

}  // namespace haptics::reaming
