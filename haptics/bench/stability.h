#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace haptics::bench {

/// The result of an extreme case, and its bound.
struct StabilityCheck {
  std::string sweep;  ///< "finite elements", "Kalman filter", "splines", "wall" …
  std::string what;
  std::string build;  ///< how it was compiled, where that was tried both ways
  double parameter = 0.0;
  double measured = 0.0;
  double bound = 0.0;  ///< that measured must not exceed
  int elements = 0;    ///< of a chain; 0: none
  bool isPassed() const { return measured <= bound; }
};

/// A virtual wall that a hand presses on.
struct VirtualWall {
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
  std::vector<VirtualWall> walls;
};

/// Adds the checks of one sweep to a result.
class SweepChecks {
 public:
  /// @param result  outlives this.
  SweepChecks(StabilityResult& result, std::string sweep)
      : result_(result), sweep_(std::move(sweep)) {}

  /// A measured value that is no number counts as infinite.
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

/// Runs all sweeps; deterministic. @p progress gets the name of each sweep before it runs.
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

/// A filter under attack: everything that an adversary chooses.
struct FilterAttack {
  double q11 = 0.0, q12 = 0.0, q22 = 0.0;
  double rElastic = 0.0, rRecorded = 0.0;
  int scheme = 0;  ///< models::KalmanScheme
  const double* travelled = nullptr;
  long steps = 0;
  bool isResting = false;  ///< all steps are nothing, and travelled is not read
};

struct FilterVerdict {
  bool isRefused = false;  ///< at load
  long negative = 0;       ///< steps after which a variance was negative
  long notFinite = 0;      ///< steps after which the force was no number
  double force = 0.0;      ///< the last one [N]
};

/// The models in one way of compiling: with products and sums rounded each by itself, or fused
/// where the processor can. The same sources are compiled twice, as two sets of types.
struct StabilityKernels {
  const char* name = "";
  double (*chainStiffness)(const double* elementStiffnesses, int elements, double tool) = nullptr;
  float (*chainStiffnessFloat)(const float* elementStiffnesses, int elements, float tool) = nullptr;
  FilterVerdict (*attack)(const FilterAttack& attack) = nullptr;
  FilterVerdict (*attackFloat)(const FilterAttack& attack) = nullptr;
  /// A cubic between two nodes at @p x; false where it is refused.
  bool (*cubic)(const double nodeA[3], const double nodeB[3], double x, double& force) = nullptr;
};

const StabilityKernels& plainKernels() noexcept;
/// nullptr where this processor, or the one that this was built for, has no fused multiply-add.
const StabilityKernels* fusedKernels() noexcept;

}  // namespace haptics::bench
