#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/reaming/packing/density_fit.h"

namespace haptics::reaming {

std::vector<double> ContactMatrix::times(std::span<const double> densities) const {
  std::vector<double> forces(rows, 0.0);
  for (std::size_t column = 0; column < columns(); ++column) {
    const double density = densities[column];
    for (std::size_t i = start[column]; i < start[column + 1]; ++i) {
      forces[row[i]] += value[i] * density;
    }
  }
  return forces;
}

std::vector<double> ContactMatrix::transposedTimes(std::span<const double> forces) const {
  std::vector<double> sums(columns(), 0.0);
  for (std::size_t column = 0; column < columns(); ++column) {
    double sum = 0.0;
    for (std::size_t i = start[column]; i < start[column + 1]; ++i) {
      sum += value[i] * forces[row[i]];
    }
    sums[column] = sum;
  }
  return sums;
}

namespace {

/// Builds a matrix whose entries are the contact area [m²] of a sphere at a depth times @p shareOf.
///
/// @param shareOf  function of (before, d, across): distance [m] of the sphere's centre from the
///                 reamer's centre along the axis, total distance, and distance from the axis.
template <typename ShareOf>
ContactMatrix matrixOf(
    const Packing& packing,
    double coverage,
    const PlungePath& plunge,
    std::span<const double> depths,
    const ShareOf& shareOf) {
  ContactMatrix matrix{.rows = depths.size(), .start = {0}, .row = {}, .value = {}};
  const double R = plunge.radius;
  for (const auto& sphere : packing.spheres) {
    const double r = sphere.radius;
    const double across = std::hypot(double{sphere.x}, double{sphere.y});
    // The reamer cuts the sphere only in a range of depths; skip the others.
    const double outer = (R + r) * (R + r) - across * across;
    const double farthest = outer > 0.0 ? std::sqrt(outer) : -1.0;
    const auto first =
        std::lower_bound(depths.begin(), depths.end(), sphere.z - farthest - plunge.start);
    for (auto depth = first; depth != depths.end() && farthest > 0.0; ++depth) {
      const double before = sphere.z - (plunge.start + *depth);
      if (before < 0.0) break;  // behind the teeth
      // The reamer's surface (radius R) cuts a cap out of the sphere, of area π R (r² − (d −
      // R)²)/d.
      const double d = std::hypot(across, before);
      const double lens = r * r - (d - R) * (d - R);
      if (lens <= 0.0) continue;
      matrix.row.push_back(static_cast<std::uint32_t>(depth - depths.begin()));
      matrix.value.push_back(
          std::numbers::pi * R * lens / d * shareOf(before, d, across) / coverage);
    }
    matrix.start.push_back(matrix.row.size());
  }
  return matrix;
}

}  // namespace

ContactMatrix contactMatrix(
    const Packing& packing,
    double coverage,
    const PlungePath& plunge,
    std::span<const double> depths) {
  // The axial component of the normal.
  return matrixOf(packing, coverage, plunge, depths, [](double before, double d, double) {
    return before / d;
  });
}

ContactMatrix leverMatrix(
    const Packing& packing,
    double coverage,
    const PlungePath& plunge,
    std::span<const double> depths) {
  return matrixOf(
      packing, coverage, plunge, depths, [](double, double, double across) { return across; });
}

ContactMatrix stacked(const ContactMatrix& upper, const ContactMatrix& lower, double weight) {
  ContactMatrix both{.rows = upper.rows + lower.rows, .start = {0}, .row = {}, .value = {}};
  for (std::size_t column = 0; column < upper.columns(); ++column) {
    for (std::size_t i = upper.start[column]; i < upper.start[column + 1]; ++i) {
      both.row.push_back(upper.row[i]);
      both.value.push_back(upper.value[i]);
    }
    for (std::size_t i = lower.start[column]; i < lower.start[column + 1]; ++i) {
      both.row.push_back(static_cast<std::uint32_t>(upper.rows + lower.row[i]));
      both.value.push_back(weight * lower.value[i]);
    }
    both.start.push_back(both.row.size());
  }
  return both;
}

std::vector<std::uint32_t> layersOf(const ContactMatrix& matrix, std::size_t layers) {
  std::vector<std::uint32_t> layerOf(matrix.columns(), static_cast<std::uint32_t>(layers));
  for (std::size_t column = 0; column < matrix.columns(); ++column) {
    if (!matrix.isTouched(column)) continue;
    // Entries are sorted by depth, so the first is the first contact.
    layerOf[column] =
        static_cast<std::uint32_t>(layers * matrix.row[matrix.start[column]] / matrix.rows);
  }
  return layerOf;
}

ContactMatrix summedByLayer(
    const ContactMatrix& matrix, std::span<const std::uint32_t> layerOf, std::size_t layers) {
  std::vector<std::vector<double>> sums(layers, std::vector<double>(matrix.rows, 0.0));
  for (std::size_t column = 0; column < matrix.columns(); ++column) {
    if (layerOf[column] >= layers) continue;
    for (std::size_t i = matrix.start[column]; i < matrix.start[column + 1]; ++i) {
      sums[layerOf[column]][matrix.row[i]] += matrix.value[i];
    }
  }
  ContactMatrix result{.rows = matrix.rows, .start = {0}, .row = {}, .value = {}};
  for (const auto& sum : sums) {
    for (std::size_t row = 0; row < matrix.rows; ++row) {
      if (sum[row] == 0.0) continue;
      result.row.push_back(static_cast<std::uint32_t>(row));
      result.value.push_back(sum[row]);
    }
    result.start.push_back(result.row.size());
  }
  return result;
}

}  // namespace haptics::reaming
