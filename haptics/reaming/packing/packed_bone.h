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

/// A bone ready to be felt and cut: a packing, and what its spheres give way at for the softest,
/// the middle and the hardest curve of a material.
struct PackedBone {
  std::string name;   ///< for files
  std::string title;  ///< for people
  bool isSynthetic = false;
  double reamerRadius = 0.026;  ///< that it was fitted with [m]
  Packing packing;
  std::vector<float> minimum;  ///< of each sphere [N/m²]
  std::vector<float> average;
  std::vector<float> maximum;
  /// Of the reamer on the spheres, fitted to a measured torque; nothing where none was.
  std::optional<double> friction = {};

  /// Densities of a hardness, blended as the curves are: forces are linear in densities.
  /// @param h  in [0, 1]. @param scale  of all of them.
  std::vector<double> densities(double h, double scale) const;
};

/// What keeps a bone from being felt with its reamer, in words: more in its spheres than its body
/// holds, spheres larger than the reamer, none in its way. Empty where nothing does.
std::string problemOf(const PackedBone& bone);

/// How well a bone was fitted to a curve.
struct CurveFit {
  std::string curve;           ///< "minimum", "average", "maximum"
  std::vector<double> depths;  ///< [m]
  std::vector<double> wanted;  ///< by the curve [N]; what lies below 0 counts as 0
  std::vector<double> felt;    ///< by the spheres [N]
  BoneFit fit;
  std::optional<double> torqueError = {};  ///< |μ B ρ − T| / |T|, where there is a torque
};

struct BoneFitReport {
  std::vector<CurveFit> curves;
  double seconds = 0.0;
  bool knowsOptimum = true;             ///< the gap of each fit bounds how far it is from it
  std::optional<double> friction = {};  ///< μ, where there was a torque
};

/// How densities come of a contact matrix and the forces that are wanted.
using DensityMethod = std::function<BoneFit(const ContactMatrix&, std::span<const double>)>;

struct BoneFitOptions {
  std::size_t depths = 400;  ///< of the force; a quarter of them of the torque
  /// μ between reamer and bone, where it is known, >= 0; otherwise it is fitted as well.
  std::optional<double> friction = {};
  std::function<void(const std::string&)> onProgress =
      {};  ///< called with the name of what is fitted next
  /// How densities come of the force alone, and friction of them afterwards; empty: fitBone(), of
  /// force and torque.
  DensityMethod method = {};
};

/// Gives the spheres of @p bone densities that follow the curves of a material, at depths evenly
/// over the longest of them (the others stay level beyond their ends), and the friction with which
/// they have its torque. The virtual experiment of the reaming paper; the paper says nothing of how
/// its spheres get a torque.
///
/// @param torque  of the material [N·m]; empty: densities follow the force alone, and the bone has
///                the friction of the options.
/// @throws std::invalid_argument  with problemOf(bone).
BoneFitReport fitTo(
    PackedBone& bone,
    const HardnessCurves& force,
    const HardnessCurves& torque = {},
    const BoneFitOptions& options = {});

/// How well one friction μ gives a bone the torque of a material.
struct FrictionFit {
  double friction = 0.0;  ///< μ, >= 0
  double error = 0.0;     ///< |μ Σaρ·distance − torque| / |torque| over all three curves
};

/// The friction with which the intact bone has the torque of a material at @p depths evenly over
/// the longest curve: least squares over the minimum, average and maximum together.
///
/// @param bone  with densities. @param torque  valid [N·m].
/// @throws std::invalid_argument  if there is no torque, or nothing is touched.
FrictionFit fitFriction(
    const PackedBone& bone, const HardnessCurves& torque, std::size_t depths = 200);

/// The testing machine of the paper: it drives the reamer in at a feed and stops at a force or a
/// depth (reaming paper, "Experimental setup").
struct ExperimentOptions {
  double feed = 0.03e-3;    ///< [m/s]
  double step = 4e-6;       ///< of the reamer between two samples [m]
  double mostDepth = 0.02;  ///< [m]
  double mostForce = 800;   ///< [N]; a dynamic test has no such limit
  double mostFeed = std::numeric_limits<double>::infinity();  ///< of the reamer's teeth [m/s]
  double cuttingDamping = BoneOptions().cuttingDamping;       ///< [N·s/m]
};

/// What the machine would have written.
struct ExperimentResult {
  std::vector<double> depth;  ///< of the tool [m], rising
  std::vector<double> force;  ///< [N]
  double removed = 0.0;       ///< mass [N·m]
  double removedShare = 0.0;  ///< of the bone's mass
  double unaccounted = 0.0;   ///< |removed + remaining − whole| / whole
  std::string stop;           ///< why it ended, for people
};

/// Reams @p bone with the densities of hardness @p h, with removal.
ExperimentResult ream(const PackedBone& bone, double h, const ExperimentOptions& options = {});

/// The force at @p depth [m], straight between two samples; NaN where the tool has not been.
double forceAt(const ExperimentResult& result, double depth);

/// How far @p result is from the force @p wanted at each of @p depths: |felt − wanted| / |wanted|
/// over those that were reached.
double errorOf(
    const ExperimentResult& result,
    const std::vector<double>& depths,
    const std::vector<double>& wanted);

}  // namespace haptics::reaming
