#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "haptics/reaming/material/exclusion.h"
#include "haptics/reaming/material/low_pass.h"
#include "haptics/reaming/material/material.h"
#include "haptics/reaming/material/node_choice.h"
#include "haptics/reaming/material/piecewise.h"
#include "haptics/reaming/material/sampled_curve.h"
#include "haptics/reaming/material/series.h"

namespace haptics::reaming {

/// How measured series become a material: every choice that the reaming paper leaves open, by name.
struct FitOptions {
  CutoffRule cutoffRule = CutoffRule::Floor;
  std::optional<double> cutoff;  ///< of every dynamic series, instead of its own [Hz]
  EnvelopeRule envelope = EnvelopeRule::SingleSample;
  NodeRule nodes = NodeRule::Greedy;
  SplineKind spline = SplineKind::HermiteDataSlope;
  double wantedError = 0.05;  ///< at the nodes' choice: max |v − v̂| / max(|v|, floor), > 0
  double forceFloor = 10.0;   ///< [N], > 0
  double torqueFloor = 0.3;   ///< [N·m], > 0
};

/// A series as it went into a material, or why it did not.
struct PreparedSeries {
  std::string name;
  TestSet set = TestSet::Dynamic1;
  Exclusion exclusion;
  double cutoff = 0.0;               ///< of its low-pass [Hz]; 0 where there was none
  double jitter = 0.0;               ///< of what the low-pass took from the force, RMS [N]
  double largestDisplacement = 0.0;  ///< [m]
  SampledCurve force;                ///< filtered [N], over shares of the largest displacement
  SampledCurve torque;               ///< [N·m]; empty where there is none
};

/// One curve of an envelope as a spline over displacement.
struct FittedCurve {
  SampledCurve data;  ///< over displacement [m]
  Spline spline;
  ApproximationError error;
};

/// The softest, the middle and the hardest curve of a test set.
struct FittedEnvelope {
  FittedCurve minimum;
  FittedCurve average;
  FittedCurve maximum;
};

/// What became of the series of a test set.
struct TestSetFit {
  TestSet set = TestSet::Dynamic1;
  int used = 0;
  double scale = 0.0;  ///< the largest displacement of all: shares become metres by it [m]
  FittedEnvelope force;
  std::optional<FittedEnvelope> torque;  ///< nothing where no series has any
  Jitter jitter;                         ///< of all its series
};

struct MaterialFit {
  std::vector<PreparedSeries> series;
  std::vector<TestSetFit> sets;  ///< those of which a series is left
};

/// A series checked, filtered (dynamic ones only, as in the paper) and normalised.
PreparedSeries prepared(const Series& series, const FitOptions& options);

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
