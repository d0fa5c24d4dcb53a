#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "haptics/filters/spectrum.h"
#include "haptics/reaming/material/envelope.h"
#include "haptics/reaming/material/material.h"
#include "haptics/reaming/material/node_choice.h"
#include "haptics/reaming/material/piecewise.h"
#include "haptics/reaming/material/sampled_curve.h"
#include "haptics/reaming/material/series.h"

namespace haptics::reaming {

/// The abscissa of the curves of a test set.
enum class DepthAxis {
  Depth,  ///< [m]: a specimen counts at the depths at which it was measured
  /// Shares of the largest displacement of the test set, tests that have ended being absent: one
  /// reading of the paper's "normalized with reference to the maximum vertical displacement for
  /// each test set".
  Normalised,
  /// Shares of a series' own largest displacement: the other reading. Every test is stretched to
  /// the length of the longest, so that a stiff specimen, whose test ended early, becomes soft.
  NormalisedSeries,
};

/// How measured series become a material: every choice that the reaming paper leaves open, by name.
struct FitOptions {
  DepthAxis axis = DepthAxis::Depth;
  filters::CutoffRule cutoffRule = filters::CutoffRule::Floor;
  std::optional<double> cutoff;        ///< of every dynamic force, instead of its own [Hz]
  std::optional<double> torqueCutoff;  ///< of every torque, instead of its own [Hz]
  EnvelopeRule envelope = EnvelopeRule::Pointwise;
  NodeRule nodes = NodeRule::Greedy;
  std::optional<std::size_t> nodeCount;  ///< so many, 2 to 200, instead of a rule and an error
  SplineKind spline = SplineKind::HermiteDataSlope;
  std::optional<SplineKind> nodesOf;  ///< nodes are chosen for this spline instead
  double wantedError = 0.05;          ///< of each spline: NodeWish, > 0
  double forceFloor = 10.0;           ///< [N], > 0
  double torqueFloor = 0.3;           ///< [N·m], > 0
  double forceLimit = 800.0;          ///< at which static tests were stopped [N], > 0
};

/// Why nothing can be fitted with these @p options; std::nullopt if it can.
std::optional<std::string> problemOf(const FitOptions& options);

/// How many places a curve has, even over its depth.
inline constexpr std::size_t kPlaces = 2001;

/// A series as it went into a material, or why it did not.
struct PreparedSeries {
  std::string name;
  TestSet set = TestSet::Dynamic1;
  Exclusion exclusion;
  double cutoff = 0.0;               ///< of the force's low-pass [Hz]; 0: not filtered
  double torqueCutoff = 0.0;         ///< of the torque's low-pass [Hz]; 0: not filtered
  double jitter = 0.0;               ///< what the low-pass removed from the force, RMS [N]
  double largestDisplacement = 0.0;  ///< [m]
  bool isCensored = false;           ///< a static test that ended at its force limit
  SampledCurve force;                ///< filtered [N], at kPlaces of depth from the beginning [m]
  SampledCurve torque;               ///< [N·m]; empty if there is none
};

/// One curve of an envelope as a spline over displacement.
struct FittedCurve {
  SampledCurve data;  ///< over displacement [m]
  Spline spline;
  ApproximationError error;
  bool isMet = true;  ///< the spline meets the requested error, or none was requested
};

/// The smallest, the mean (or the middle specimen) and the largest curve of a test set.
struct FittedEnvelope {
  FittedCurve minimum;
  FittedCurve average;
  FittedCurve maximum;
  bool isOrdered = false;     ///< everywhere, by construction: orderedSplines()
  std::vector<int> measured;  ///< at each place of the data: whose tests go on
  std::vector<int> held;      ///< and that count with the force limit at which they ended
};

/// A stretch of depth over which the same specimens count.
struct SpecimensLeft {
  double from = 0.0;  ///< [m]
  int measured = 0;
  int held = 0;
};

/// The stretches of an envelope from its beginning.
std::vector<SpecimensLeft> specimensLeftOf(const FittedEnvelope& envelope);

/// The result for each series of a test set.
struct TestSetFit {
  TestSet set = TestSet::Dynamic1;
  int used = 0;
  double scale = 0.0;  ///< the largest displacement of all [m]
  FittedEnvelope force;
  std::optional<FittedEnvelope> torque;  ///< std::nullopt if no series has any
  Jitter jitter;                         ///< of all its series
};

struct MaterialFit {
  std::vector<PreparedSeries> series;
  std::vector<TestSetFit> sets;  ///< those of which a series is left
};

/// A series checked, and filtered (dynamic ones only, as in the paper), the torque by a low-pass of
/// its own.
PreparedSeries prepared(const Series& series, const FitOptions& options);

/// The options of `palpate material fit` to change so that curves are in order everywhere; empty if
/// they are.
std::vector<std::string> optionsThatKeepOrder(const FitOptions& options);

/// Where a harder curve of an envelope lies below a softer one: there a higher hardness feels
/// softer.
struct Crossing {
  double from = 0.0;  ///< [m]
  double to = 0.0;    ///< [m]
};

/// Every stretch of @p envelope over which its curves are out of order by more than @p tolerance
/// [N].
std::vector<Crossing> crossingsOf(const FittedEnvelope& envelope, double tolerance);

/// The whole way from series to splines: reaming paper, "Data filtering, normalization and
/// interpolation".
MaterialFit fitMaterial(std::span<const Series> series, const FitOptions& options);

}  // namespace haptics::reaming
