#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "haptics/reaming/bone/packing.h"
#include "haptics/reaming/bone/sphere_field.h"

namespace haptics::reaming {

/// The matrix A of F = A ρ: axial forces F at the depths of a plunge into the whole bone (rows),
/// from the densities ρ of the spheres (columns). Sparse, stored by columns; a column's entries are
/// sorted by depth.
struct ContactMatrix {
  std::size_t rows = 0;            ///< depths
  std::vector<std::size_t> start;  ///< first entry of each column, and the end of the last
  std::vector<std::uint32_t> row;  ///< row of each entry
  std::vector<double> value;       ///< [m²]

  std::size_t columns() const noexcept { return start.size() - 1; }
  bool isTouched(std::size_t column) const noexcept { return start[column] < start[column + 1]; }

  /// A ρ. @param densities one per column.
  std::vector<double> times(std::span<const double> densities) const;
  /// Aᵀ y. @param forces y, one per row.
  std::vector<double> transposedTimes(std::span<const double> forces) const;
};

/// @param depths  of the plunge, increasing [m]. @param coverage of the packing; contact areas are
///                divided by it.
ContactMatrix contactMatrix(
    const Packing& packing,
    double coverage,
    const PlungePath& plunge,
    std::span<const double> depths);

/// The matrix B of T = μ B ρ: torques about the axis from friction μ and densities. Rows and
/// columns as in contactMatrix(); values [m³].
ContactMatrix leverMatrix(
    const Packing& packing,
    double coverage,
    const PlungePath& plunge,
    std::span<const double> depths);

/// The rows of @p upper, followed by those of @p lower times @p weight.
ContactMatrix stacked(const ContactMatrix& upper, const ContactMatrix& lower, double weight);

/// Assigns each sphere to a layer by the depth of its first contact. Spheres without contact get
/// the number @p layers.
std::vector<std::uint32_t> layersOf(const ContactMatrix& matrix, std::size_t layers);

/// The matrix with one column per layer: the sum of the layer's columns.
ContactMatrix summedByLayer(
    const ContactMatrix& matrix, std::span<const std::uint32_t> layerOf, std::size_t layers);

/// Densities with which a bone has the wanted forces, and the quality of the fit.
struct DensityFit {
  std::vector<double> densities;  ///< one per column [N/m²], >= 0
  double error = 0.0;             ///< |A ρ − F| / |F|
  /// Relative duality gap (primal − dual) / primal: an upper bound of the distance from the
  /// optimum. NaN if the method has no bound.
  double gap = 0.0;
  int iterations = 0;
};

/// Minimises ½|A ρ − F|² + ½ λ |ρ − ρ₀|² over ρ ≥ 0 by Newton's method on the dual, which has one
/// unknown per depth: F·y − ½|y|² + ½ λ|ρ(y) − ρ₀|² − y·A ρ(y), ρ(y) = max(0, ρ₀ + Aᵀy/λ). λ is
/// reduced in steps from a large value, each step starting from the last solution: from a start at
/// zero the method diverges if many densities leave 0 in one step.
///
/// @param prior   ρ₀: decides between densities that the forces do not distinguish.
/// @param weight  λ relative to the mean squared norm of A's rows, > 0. The default is so small
///     that the prior only decides what the forces leave open.
DensityFit fitNonNegative(
    const ContactMatrix& matrix,
    std::span<const double> forces,
    std::span<const double> prior,
    double weight = 1e-6);

/// The reaming paper's method: a particle swarm (Kennedy & Eberhart 1995, with the constriction
/// factor of Clerc & Kennedy 2002). The paper does not state its parameters.
struct SwarmOptions {
  int particles = 40;
  int iterations = 500;
  double most = 0.0;  ///< largest density [N/m²]; 0: five times the best uniform density
  std::uint64_t seed = 1;
  int threads = 2;       ///< the result does not depend on it
  double seconds = 0.0;  ///< time limit; 0: none
};
DensityFit fitSwarm(
    const ContactMatrix& matrix, std::span<const double> forces, const SwarmOptions& options);

/// The density that fits best if all spheres have the same density.
double uniformDensity(const ContactMatrix& matrix, std::span<const double> forces);

/// |A ρ − F| / |F|; if F is 0: 0 for A ρ = 0, else 1.
double errorOf(
    const ContactMatrix& matrix, std::span<const double> densities, std::span<const double> forces);

/// A fit of the densities of all spheres in two steps: first one density per layer (spheres that
/// are never touched get that of the deepest), then, with these as the prior, one density per
/// sphere.
struct BoneFit {
  std::vector<double> densities;
  DensityFit layers;
  DensityFit spheres;
  /// Fraction of the spheres that are touched; the others keep the prior.
  double touchedShare = 0.0;
};
BoneFit fitBone(
    const ContactMatrix& matrix, std::span<const double> forces, std::size_t layers = 12);

/// The equations of the torque, T = μ B ρ.
struct TorqueRows {
  ContactMatrix levers;         ///< B, with the same columns as the matrix of the force
  std::vector<double> torques;  ///< T [N·m], one per row
  double friction = 0.0;        ///< μ
};

/// Fits force and torque together: minimises |A ρ − F|²/|F|² + |μ B ρ − T|²/|T|², so that relative
/// errors of both have equal weight. The errors in the result are those of the force.
BoneFit fitBone(
    const ContactMatrix& matrix,
    std::span<const double> forces,
    const TorqueRows& torque,
    std::size_t layers = 12);

/// The friction μ that minimises the sum of fitBone() with @p torque, from thirteen values between
/// 1/8 and 2 times the friction that fits uniform density. Force and torque alone do not separate
/// friction from the distribution of density, so this is a parameter of the fit, not a property of
/// bone.
double bestFriction(const ContactMatrix& matrix, std::span<const double> forces, TorqueRows torque);

/// Fits the force by the paper's particle swarm. The gap is NaN, since the method has no bound.
///
/// @param layers  number of layers of one density each; spheres that are never touched get that of
///                the deepest. 0: each touched sphere has its own density, the others their mean.
BoneFit fitBoneBySwarm(
    const ContactMatrix& matrix,
    std::span<const double> forces,
    std::size_t layers,
    const SwarmOptions& options);

}  // namespace haptics::reaming
