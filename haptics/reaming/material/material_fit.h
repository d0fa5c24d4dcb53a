#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "haptics/filters/spectrum.h"
#include "haptics/reaming/material/envelope.h"
#include "haptics/reaming/material/material.h"
#include "haptics/reaming/material/node_choice.h"
#include "haptics/reaming/material/sampled_curve.h"
#include "haptics/reaming/material/series.h"
#include "haptics/reaming/material/spline.h"

namespace haptics::reaming {

/// The abscissa of the curves of a test set.
enum class DepthAxis {
  Depth,  ///< depth [m], see depthEnvelopeOf()
  /// Displacement relative to the largest of the test set; ended tests do not count: one
  /// interpretation of the paper's "normalized with reference to the maximum vertical displacement
  /// for each test set".
  Normalised,
  /// Displacement relative to the largest of the series: the other interpretation. Every test is
  /// stretched to the length of the longest, so a stiff specimen, whose test ended early, becomes
  /// soft.
  NormalisedSeries,
};

/// Options of the fit of a material to measured series: the choices that the reaming paper leaves
/// open.
struct FitOptions {
  DepthAxis axis = DepthAxis::Depth;
  filters::CutoffRule cutoffRule = filters::CutoffRule::Floor;
  std::optional<double> cutoff;        ///< for every dynamic force, instead of one per series [Hz]
  std::optional<double> torqueCutoff;  ///< for every torque, instead of one per series [Hz]
  EnvelopeRule envelope = EnvelopeRule::Pointwise;
  NodeRule nodes = NodeRule::Greedy;
  /// Fixed number of nodes, 2 to 200, instead of rule and error.
  std::optional<std::size_t> nodeCount;
  SplineKind spline = SplineKind::HermiteDataSlope;
  std::optional<SplineKind> nodesOf;  ///< chooses nodes as for this kind of spline
  double wantedError = 0.05;          ///< largest error of each spline, see NodeCriterion, > 0
  double forceFloor = 10.0;           ///< NodeCriterion::floor of forces [N], > 0
  double torqueFloor = 0.3;           ///< NodeCriterion::floor of torques [N·m], > 0
  double forceLimit = 800.0;          ///< force at which static tests were stopped [N], > 0
};

/// Why @p options are not valid; std::nullopt if they are.
std::optional<std::string> problemOf(const FitOptions& options);

/// Number of samples of a curve, evenly spaced over its depth.
inline constexpr std::size_t kSampleCount = 2001;

/// A series as used for a material, or the reason why it was excluded.
struct PreparedSeries {
  std::string name;
  TestSet set = TestSet::Dynamic1;
  Exclusion exclusion;
  double cutoff = 0.0;               ///< of the force's low-pass [Hz]; 0: not filtered
  double torqueCutoff = 0.0;         ///< of the torque's low-pass [Hz]; 0: not filtered
  double jitter = 0.0;               ///< RMS of what the low-pass removed from the force [N]
  double largestDisplacement = 0.0;  ///< [m]
  bool isCensored = false;           ///< a static test that ended at its force limit
  SampledCurve
      force;  ///< filtered force [N], at kSampleCount depths from the beginning of the test [m]
  SampledCurve torque;  ///< [N·m]; empty if there is none
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
  bool isOrdered = false;     ///< the splines cannot cross: orderedSplines()
  std::vector<int> measured;  ///< at each abscissa of the data, see DepthEnvelope
  std::vector<int> held;      ///< at each abscissa of the data, see DepthEnvelope
};

/// A range of depth in which the numbers of specimens are constant; it ends where the next begins.
struct SpecimenCounts {
  double from = 0.0;  ///< [m]
  int measured = 0;
  int held = 0;
};

/// The ranges of an envelope, by depth.
std::vector<SpecimenCounts> specimenCountsOf(const FittedEnvelope& envelope);

/// The fit of one test set.
struct TestSetFit {
  TestSet set = TestSet::Dynamic1;
  int used = 0;
  double scale = 0.0;  ///< the largest displacement of all used series [m]
  FittedEnvelope force;
  std::optional<FittedEnvelope> torque;  ///< std::nullopt if no series has a torque
  Jitter jitter;                         ///< over all series
};

struct MaterialFit {
  std::vector<PreparedSeries> series;
  std::vector<TestSetFit> sets;  ///< test sets with at least one series that was not excluded
};

/// Checks a series and filters it (only dynamic ones, as in the paper); the torque has its own
/// cut-off.
PreparedSeries prepared(const Series& series, const FitOptions& options);

/// The options of `palpate material fit` that must be changed so that curves cannot cross; empty if
/// they already cannot.
std::vector<std::string> optionsAgainstCrossing(const FitOptions& options);

/// A range in which a harder curve of an envelope is below a softer one.
struct Crossing {
  double from = 0.0;  ///< [m]
  double to = 0.0;    ///< [m]
};

/// All ranges of @p envelope in which curves cross by more than @p tolerance [N].
std::vector<Crossing> crossingsOf(const FittedEnvelope& envelope, double tolerance);

/// Fits a material to series: reaming paper, "Data filtering, normalization and interpolation".
MaterialFit fitMaterial(std::span<const Series> series, const FitOptions& options);

}  // namespace haptics::reaming
