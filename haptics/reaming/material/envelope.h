#pragma once

#include <span>
#include <vector>

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

}  // namespace haptics::reaming
