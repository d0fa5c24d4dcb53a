#pragma once

#include <optional>
#include <string>
#include <vector>

#include "haptics/models/hermite_curve.h"
#include "haptics/reaming/material/series.h"

namespace haptics::reaming {

using CurveNodes = std::vector<models::HermiteNode<double>>;

/// The softest, middle and hardest curve over displacement [m], each with its own nodes: forces [N]
/// or torques [N·m].
struct HardnessCurves {
  CurveNodes minimum;
  CurveNodes average;
  CurveNodes maximum;

  bool isEmpty() const noexcept { return minimum.empty(); }
  /// The displacement at which the last of the curves ends [m]; none may be empty.
  double end() const noexcept;
};

/// The curve of hardness h: minimum at 0, average at 0.5, maximum at 1, linearly blended in
/// between. The blend is exact: a cubic between each two nodes of the union of all nodes.
///
/// @param curves  valid, not empty. @param h  in [0, 1].
CurveNodes curveOf(const HardnessCurves& curves, double h);

/// The force of a curve at @p depth [m]; constant beyond its ends.
double forceOf(const CurveNodes& nodes, double depth);

/// Why @p curves are invalid; std::nullopt if they are valid. Curves may cross, as those of single
/// specimens do.
std::optional<std::string> problemOf(const HardnessCurves& curves);

/// The part of the measured force that the low-pass removed, which the splines lack; rendered as
/// noise.
struct Jitter {
  double rms = 0.0;     ///< [N]; 0: none
  double rate = 100.0;  ///< sampling rate of the measurement [Hz]
};

/// The curves fitted to the series of a test set.
struct MaterialSet {
  TestSet set = TestSet::Dynamic1;
  HardnessCurves force;
  HardnessCurves torque;  ///< empty if none was measured
  Jitter jitter;
};

/// A reaming material: the content of a material file.
struct Material {
  std::string name;   ///< for files and protocols
  std::string title;  ///< as shown to users
  bool isSynthetic = false;
  std::vector<MaterialSet> sets;

  const MaterialSet* find(TestSet set) const noexcept;
};

}  // namespace haptics::reaming
