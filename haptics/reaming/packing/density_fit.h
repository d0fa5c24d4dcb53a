#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "haptics/reaming/bone/packing.h"
#include "haptics/reaming/bone/sphere_field.h"

namespace haptics::reaming {

/// What every sphere adds to the force along the axis, per density, at every depth of a plunge into
/// a bone of which nothing is missing: F = A ρ. Column by column, a sphere's depths in order.
struct ContactMatrix {
  std::size_t rows = 0;            ///< depths
  std::vector<std::size_t> start;  ///< of each column's entries, and the end of the last
  std::vector<std::uint32_t> row;  ///< of each entry
  std::vector<double> value;       ///< [m²]

  std::size_t columns() const noexcept { return start.size() - 1; }
  bool isTouched(std::size_t column) const noexcept { return start[column] < start[column + 1]; }

  /// A ρ. @param densities  as many as columns.
  std::vector<double> times(std::span<const double> densities) const;
  /// Aᵀ y. @param forces  as many as rows.
  std::vector<double> transposedTimes(std::span<const double> forces) const;
};

/// @param depths  of the plunge [m]. @param coverage  of the packing, by which areas are divided.
ContactMatrix contactMatrix(
    const Packing& packing,
    double coverage,
    const StrokeRange& plunge,
    std::span<const double> depths);

/// What every sphere adds to the torque about the axis, per density and friction, at every depth:
/// T = μ B ρ. Of the same shape as the contact matrix; values [m³].
ContactMatrix leverMatrix(
    const Packing& packing,
    double coverage,
    const StrokeRange& plunge,
    std::span<const double> depths);

/// The rows of @p upper, and below them those of @p lower times @p weight.
ContactMatrix stacked(const ContactMatrix& upper, const ContactMatrix& lower, double weight);

/// Spheres in layers: of each sphere the layer, by the depth at which it is first touched, or
/// @p layers where it never is.
std::vector<std::uint32_t> layersOf(const ContactMatrix& matrix, std::size_t layers);

/// The columns of each layer added up.
ContactMatrix layered(
    const ContactMatrix& matrix, std::span<const std::uint32_t> layerOf, std::size_t layers);

/// Densities that make a bone feel like a curve, and how well they do.
struct DensityFit {
  std::vector<double> densities;  ///< of each column [N/m²], >= 0
  double error = 0.0;             ///< |A ρ − F| / |F|
  /// (P − D) / P of the problem that was solved: how far above the optimum it can be at most. NaN
  /// where the method knows no bound.
  double gap = 0.0;
  int iterations = 0;
};

/// min ½|A ρ − F|² + ½ λ |ρ − ρ₀|², ρ ≥ 0, by Newton's method on its dual, which has as many
/// unknowns as there are depths: F·y − ½|y|² + ½ λ|ρ(y) − ρ₀|² − y·A ρ(y), ρ(y) = max(0, ρ₀ +
/// Aᵀy/λ). From a large λ down to the wanted one, each time from the last solution: started
/// from zero, the method diverges where many densities leave 0 in one step.
///
/// @param prior   ρ₀: what spheres are that the experiment does not tell apart.
/// @param weight  λ as a share of the mean squared row of A, > 0; so small by default that the
/// prior
///     decides only what the forces leave open.
DensityFit fitNonNegative(
    const ContactMatrix& matrix,
    std::span<const double> forces,
    std::span<const double> prior,
    double weight = 1e-6);

/// Multiplicative: ρ ← ρ · Aᵀ(F / A ρ) / Aᵀ1 (MLEM, Shepp & Vardi 1982). Forces below 0 count as 0.
DensityFit fitMultiplicative(
    const ContactMatrix& matrix,
    std::span<const double> forces,
    std::span<const double> prior,
    int iterations);

/// The reaming paper's way: a particle swarm (Kennedy & Eberhart 1995, with the constriction of
/// Clerc & Kennedy 2002). The paper says nothing of its size or settings.
struct SwarmOptions {
  int particles = 40;
  int iterations = 500;
  double most = 0.0;  ///< density [N/m²]; 0: five times the uniform density that fits best
  std::uint64_t seed = 1;
  int threads = 2;       ///< any number; the result is the same
  double seconds = 0.0;  ///< time limit; 0: none
};
DensityFit fitSwarm(
    const ContactMatrix& matrix, std::span<const double> forces, const SwarmOptions& options);

/// The one density that fits best.
double uniformDensity(const ContactMatrix& matrix, std::span<const double> forces);

/// |A ρ − F| / |F|; where no force is wanted, 0 or 1.
double errorOf(
    const ContactMatrix& matrix, std::span<const double> densities, std::span<const double> forces);

/// How every sphere of a bone gets its density: first the densities of a few layers, of which the
/// deepest is also used for the spheres that the experiment never touches, then every sphere.
struct BoneFit {
  std::vector<double> densities;
  DensityFit layers;
  DensityFit spheres;
  double touchedShare = 0.0;  ///< of all spheres; the others have the prior only
};
BoneFit fitBone(
    const ContactMatrix& matrix, std::span<const double> forces, std::size_t layers = 12);

/// What the torque adds to the problem of a bone: T = μ B ρ.
struct TorqueRows {
  ContactMatrix levers;         ///< B, of the columns of the force's matrix
  std::vector<double> torques;  ///< T [N·m], as many as rows
  double friction = 0.0;        ///< μ
};

/// The same by force and torque at once: |A ρ − F|²/|F|² + |μ B ρ − T|²/|T|², so that a percent of
/// the one weighs as much as a percent of the other. The errors are those of the force.
BoneFit fitBone(
    const ContactMatrix& matrix,
    std::span<const double> forces,
    const TorqueRows& torque,
    std::size_t layers = 12);

/// The friction of @p torque with which that sum is least, of thirteen between an eighth and twice
/// that of spheres of one density. Force and torque alone do not tell friction from where the
/// density lies, so this is the friction of the fit, not a property of bone.
double bestFriction(const ContactMatrix& matrix, std::span<const double> forces, TorqueRows torque);

/// The same by the paper's swarm alone, which has no optimum to compare itself with: the gap is
/// NaN.
///
/// @param layers  by depth, each of one density; the spheres that are never touched are as the
///                deepest. 0: each touched sphere has its own density, the others their mean.
BoneFit fitBoneBySwarm(
    const ContactMatrix& matrix,
    std::span<const double> forces,
    std::size_t layers,
    const SwarmOptions& options);

}  // namespace haptics::reaming
