#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace haptics::bench {

/// A measured value of a stress test, and its bound.
struct StabilityCheck {
  std::string sweep;  ///< "finite elements", "Kalman filter", "splines", "wall" …
  std::string what;
  std::string build;  ///< name of the StabilityKernels; empty if not applicable
  double parameter = 0.0;
  double measured = 0.0;
  double bound = 0.0;  ///< largest allowed value of measured
  int elements = 0;    ///< number of elements of a chain; 0: not a chain
  bool isPassed() const { return measured <= bound; }
};

/// A virtual wall on which a hand presses, and the result of the simulation.
struct VirtualWall {
  double rate = 0.0;       ///< [Hz]
  double stiffness = 0.0;  ///< K [N/travel unit]
  double damping = 0.0;    ///< b, of mechanism and hand together [N·s/travel unit]
  double quantum = 0.0;    ///< resolution of the encoder [travel units]
  int delay = 0;           ///< delay of the force [ticks]
  bool hasPassivityController = false;
  bool isStable = false;
  bool isPassivityUnproven = false;   ///< eq. (25) of the punch paper does not guarantee passivity
  bool isDetectedByObserver = false;  ///< the energy observer detected generated energy
  double amplitude = 0.0;             ///< peak to peak over the last 0.4 s [travel units]
};

struct StabilityResult {
  std::vector<StabilityCheck> checks;
  std::vector<VirtualWall> walls;
};

/// Adds checks of one sweep to a result.
class SweepChecks {
 public:
  /// @param result  must outlive this object.
  SweepChecks(StabilityResult& result, std::string sweep)
      : result_(result), sweep_(std::move(sweep)) {}

  /// Adds a check. A measured NaN counts as infinite.
  void add(
      std::string what,
      double parameter,
      double measured,
      double bound,
      const char* build = "",
      int elements = 0);

 private:
  StabilityResult& result_;
  std::string sweep_;
};

/// Runs all sweeps; deterministic. Calls @p progress with the name of each sweep before it runs.
/// @param effort  fraction of the random cases to run, up to 1; less for a quick check.
StabilityResult runStability(
    double effort, const std::function<void(const std::string&)>& progress);

// The single sweeps; each adds to the result.
void sweepFiniteElements(double effort, StabilityResult& result);
void sweepFilter(double effort, StabilityResult& result);
void sweepSplines(double effort, StabilityResult& result);
void sweepWalls(double effort, StabilityResult& result);
void sweepRates(double effort, StabilityResult& result);
void sweepBadInput(double effort, StabilityResult& result);
void sweepReaming(double effort, StabilityResult& result);

/// A stress test of a Kalman filter: its noise, scheme and steps.
struct FilterStressTest {
  double q11 = 0.0, q12 = 0.0, q22 = 0.0;
  double rElastic = 0.0, rRecorded = 0.0;
  int scheme = 0;  ///< models::KalmanScheme
  const double* travelled = nullptr;
  long steps = 0;
  bool isResting = false;  ///< all steps are 0; travelled is not read
};

struct FilterStressResult {
  bool isNoiseRefused = false;  ///< the noise was refused as not valid
  long negative = 0;            ///< number of steps after which a variance was negative
  long notFinite = 0;           ///< number of steps after which the force was not finite
  double force = 0.0;           ///< last force [N]
};

/// Entry points to the models in one build: with separate multiplication and addition, or with
/// fused multiply-add. The same sources are compiled twice, under different namespaces.
struct StabilityKernels {
  const char* name = "";
  double (*chainStiffness)(const double* elementStiffnesses, int elements, double tool) = nullptr;
  float (*chainStiffnessFloat)(const float* elementStiffnesses, int elements, float tool) = nullptr;
  FilterStressResult (*stressTest)(const FilterStressTest& test) = nullptr;
  FilterStressResult (*stressTestFloat)(const FilterStressTest& test) = nullptr;
  /// Evaluates a cubic between two nodes at @p x; returns false if the nodes are refused.
  bool (*cubic)(const double nodeA[3], const double nodeB[3], double x, double& force) = nullptr;
};

const StabilityKernels& plainKernels() noexcept;
/// nullptr if this processor, or the one that this was built for, has no fused multiply-add.
const StabilityKernels* fusedKernels() noexcept;

}  // namespace haptics::bench
