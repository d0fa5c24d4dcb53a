#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "haptics/reaming/bone/bone.h"
#include "haptics/reaming/bone/packing.h"
#include "haptics/reaming/material/material.h"
#include "haptics/reaming/packing/density_fit.h"

namespace haptics::reaming {

/// A bone of spheres: a packing, and the densities of its spheres for the softest, middle and
/// hardest curve of a material.
struct PackedBone {
  std::string name;   ///< used in files
  std::string title;  ///< as shown to users
  bool isSynthetic = false;
  double reamerRadius = 0.026;  ///< radius of the reamer for which the densities were fitted [m]
  Packing packing;
  std::vector<float> minimum;  ///< densities, one per sphere [N/m²]
  std::vector<float> average;
  std::vector<float> maximum;
  /// Coefficient of friction between reamer and spheres, fitted to a measured torque; std::nullopt
  /// if no torque was fitted.
  std::optional<double> friction = {};

  /// Densities for a hardness, blended like the curves (forces are linear in densities).
  /// @param h  in [0, 1]. @param scale factor of all densities.
  std::vector<double> densities(double h, double scale) const;
};

/// A message if the bone cannot be used with its reamer: the volume of the spheres exceeds that of
/// the body, spheres are larger than the reamer, or none is in its path. Empty if the bone is
/// valid.
std::string problemOf(const PackedBone& bone);

/// How well a bone was fitted to a curve.
struct CurveFit {
  std::string curve;                ///< "minimum", "average", "maximum"
  std::vector<double> depths;       ///< [m]
  std::vector<double> wanted;       ///< force of the curve [N]; negative values count as 0
  std::vector<double> fittedForce;  ///< force of the spheres [N]
  BoneFit fit;
  std::optional<double> torqueError = {};  ///< |μ B ρ − T| / |T|, if there is a torque
};

struct BoneFitReport {
  std::vector<CurveFit> curves;
  double seconds = 0.0;
  bool hasOptimalityGap = true;         ///< DensityFit::gap of each fit is valid
  std::optional<double> friction = {};  ///< μ, if there was a torque
};

/// Fits densities, given a contact matrix and the wanted forces.
using DensityMethod = std::function<BoneFit(const ContactMatrix&, std::span<const double>)>;

struct BoneFitOptions {
  std::size_t depths = 400;  ///< number of depths of the force; the torque uses a quarter of them
  /// μ between reamer and bone, >= 0; std::nullopt: μ is fitted.
  std::optional<double> friction = {};
  /// Called before each curve is fitted, with its name; may be empty.
  std::function<void(const std::string&)> onProgress = {};
  /// A method that fits the densities to the force only; friction is fitted afterwards. Empty: the
  /// exact fit, fitBone(), to force and torque.
  DensityMethod method = {};
};

/// Fits the densities of @p bone to the force curves of a material, at evenly spaced depths over
/// the longest curve (the others are constant beyond their ends), and the friction to its torque.
/// This is the virtual experiment of the reaming paper, which does not say how its spheres produce
/// a torque.
///
/// @param torque  of the material [N·m]; empty: densities are fitted to the force only, and the
///                bone has the friction of the options.
/// @throws std::invalid_argument  with problemOf(bone), if not empty.
BoneFitReport fitBoneToMaterial(
    PackedBone& bone,
    const HardnessCurves& force,
    const HardnessCurves& torque = {},
    const BoneFitOptions& options = {});

/// A friction fitted to the torque of a material.
struct FrictionFit {
  double friction = 0.0;  ///< μ, >= 0
  double error = 0.0;     ///< |μ Σaρ·distance − torque| / |torque| over all three curves
};

/// Fits the friction of the whole bone to the torque of a material, at @p depths evenly spaced
/// depths over the longest curve: least squares over minimum, average and maximum together.
///
/// @param bone  has densities. @param torque valid [N·m].
/// @throws std::invalid_argument  if there is no torque, or the reamer touches no sphere.
FrictionFit fitFriction(
    const PackedBone& bone, const HardnessCurves& torque, std::size_t depths = 200);

/// Parameters of a simulated testing machine, which advances the reamer at a constant feed and
/// stops at a force or a depth (reaming paper, "Experimental setup").
struct ExperimentOptions {
  double feed = 0.03e-3;      ///< [m/s]
  double step = 4e-6;         ///< advance between two samples [m]
  double mostDepth = 0.02;    ///< [m]
  double largestForce = 800;  ///< [N]; dynamic tests have no such limit
  double mostFeed = std::numeric_limits<double>::infinity();  ///< largest feed that the reamer's
                                                              ///< teeth allow [m/s]
  double cuttingDamping = BoneOptions().cuttingDamping;       ///< [N·s/m]
};

/// The recording of the simulated machine.
struct ExperimentResult {
  std::vector<double> depth;  ///< of the tool [m], increasing
  std::vector<double> force;  ///< [N]
  double removed = 0.0;       ///< removed mass [N·m]
  double removedShare = 0.0;  ///< removed fraction of the bone's mass
  double unaccounted = 0.0;  ///< error of the mass balance: |removed + remaining − whole| / whole
  std::string stop;          ///< why it stopped, as shown to users
};

/// Simulates reaming of @p bone with the densities of hardness @p h, with removal.
ExperimentResult ream(const PackedBone& bone, double h, const ExperimentOptions& options = {});

/// The force at @p depth [m], linearly interpolated; NaN outside the recorded depths.
double forceAt(const ExperimentResult& result, double depth);

/// Relative error |fitted − wanted| / |wanted| of the forces of @p result against @p wanted [N] at
/// @p depths [m], over those depths that were reached.
double errorOf(
    const ExperimentResult& result,
    const std::vector<double>& depths,
    const std::vector<double>& wanted);

}  // namespace haptics::reaming
