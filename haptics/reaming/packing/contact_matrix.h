#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "haptics/reaming/bone/packing.h"
#include "haptics/reaming/bone/plunge.h"

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
    const Packing& packing, double coverage, const Plunge& plunge, std::span<const double> depths);

/// Spheres in layers: of each sphere the layer, by the depth at which it is first touched, or
/// @p layers where it never is.
std::vector<std::uint32_t> layersOf(const ContactMatrix& matrix, std::size_t layers);

/// The columns of each layer added up.
ContactMatrix layered(
    const ContactMatrix& matrix, std::span<const std::uint32_t> layerOf, std::size_t layers);

}  // namespace haptics::reaming
