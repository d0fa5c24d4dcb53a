#pragma once

namespace haptics::bench {

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
