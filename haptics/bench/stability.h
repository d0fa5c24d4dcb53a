#pragma once

#include <functional>
#include <string>
#include <vector>

namespace haptics::bench {

/// What came out of an extreme case, and what had to.
struct StabilityCheck {
  std::string sweep;  ///< "finite elements", "Kalman filter", "splines", "wall" …
  std::string what;
  std::string build;  ///< how it was compiled, where that was tried both ways
  double parameter = 0.0;
  double measured = 0.0;
  double bound = 0.0;  ///< that measured must not exceed
  bool isPassed() const { return measured <= bound; }
};

/// A virtual wall that a hand presses on.
struct WallPoint {
  double rate = 0.0;       ///< [Hz]
  double stiffness = 0.0;  ///< K [N/travel unit]
  double damping = 0.0;    ///< b, of mechanism and hand together [N·s/travel unit]
  double quantum = 0.0;    ///< of the encoder [travel units]
  int delay = 0;           ///< of the force [ticks]
  bool isControlled = false;
  bool isStable = false;
  bool isForeseen = false;  ///< eq. (25) says that it need not be
  bool isNoticed = false;   ///< by the energy observer
  double amplitude = 0.0;   ///< peak to peak over the last 0.4 s [travel units]
};

struct StabilityResult {
  std::vector<StabilityCheck> checks;
  std::vector<WallPoint> walls;
};

/// Runs all sweeps; deterministic. @p progress is told what comes next.
/// @param effort  1 for all of it; less draws fewer random cases, for a quick check.
StabilityResult runStability(
    double effort, const std::function<void(const std::string&)>& progress);

// The sweeps one by one; each adds to the result.
void sweepFiniteElements(double effort, StabilityResult& result);
void sweepFilter(double effort, StabilityResult& result);
void sweepSplines(double effort, StabilityResult& result);
void sweepWalls(double effort, StabilityResult& result);
void sweepRates(double effort, StabilityResult& result);
void sweepBadInput(double effort, StabilityResult& result);
void sweepReaming(double effort, StabilityResult& result);

}  // namespace haptics::bench
