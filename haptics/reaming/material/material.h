#pragma once

#include <optional>
#include <string>
#include <vector>

#include "haptics/models/hermite_curve.h"
#include "haptics/reaming/material/series.h"

namespace haptics::reaming {

using CurveNodes = std::vector<models::HermiteNode<double>>;

/// The softest, the middle and the hardest curve over displacement [m], each with nodes of its own:
/// forces in N, or torques in N·m.
struct HardnessCurves {
  CurveNodes minimum;
  CurveNodes average;
  CurveNodes maximum;

  bool isEmpty() const noexcept { return minimum.empty(); }
};

/// The curve of a hardness h: minimum at 0, average at 0.5, maximum at 1, in between straight from
/// one to the next. A cubic on every interval between the nodes of all three, exactly.
///
/// @param curves  valid, not empty. @param h  in [0, 1].
CurveNodes curveOf(const HardnessCurves& curves, double h);

/// The force of a curve at @p depth [m]; beyond its ends, that of the end.
double forceOf(const CurveNodes& nodes, double depth);

/// Why @p curves are invalid; std::nullopt if they are valid. Values are not checked against each
/// other: single samples may cross.
std::optional<std::string> problemOf(const HardnessCurves& curves);

/// What a low-pass took from the measured force: the hand feels it, the splines do not hold it.
struct Jitter {
  double rms = 0.0;     ///< [N]; 0: none
  double rate = 100.0;  ///< at which it was sampled [Hz]
};

/// What was made of the series of a test set.
struct MaterialSet {
  TestSet set = TestSet::Dynamic1;
  HardnessCurves force;
  HardnessCurves torque;  ///< empty where none was measured
  Jitter jitter;
};

/// A reaming material ready to be felt: the content of a material file.
struct Material {
  std::string name;   ///< for files and protocols
  std::string title;  ///< for people
  bool isSynthetic = false;
  std::vector<MaterialSet> sets;

  const MaterialSet* find(TestSet set) const noexcept;
};

}  // namespace haptics::reaming
