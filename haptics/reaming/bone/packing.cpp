#include "haptics/reaming/bone/packing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace haptics::reaming {

double Packing::filled() const noexcept {
  double sum = 0.0;
  for (const auto& sphere : spheres) sum += std::pow(static_cast<double>(sphere.radius), 3.0);
  return 4.0 / 3.0 * std::numbers::pi * sum;
}

PackingFlaws flawsOf(const Packing& packing, const Solid& body) {
  // Finds overlaps with a grid of columns, so that every pair of near spheres is compared once.
  PackingFlaws flaws;
  const auto& spheres = packing.spheres;
  if (spheres.empty()) return flaws;
  double largest = 0.0;
  for (const auto& sphere : spheres) {
    const double radius = sphere.radius;
    largest = std::max(largest, radius);
    const double out = radius - body.nearest(sphere.centre()).distance;
    flaws.protrusion = std::max(flaws.protrusion, out / radius);
  }
  // Columns are as wide as the largest sphere and sorted along z, so a sphere can meet others in
  // nine columns only.
  const double width = 2.0 * largest;
  const Vec3 low = body.lowerCorner();
  const auto across = [&](double from, double to) {
    return static_cast<std::size_t>((to - from) / width) + 3;
  };
  const std::size_t columnsX = across(low.x, body.upperCorner().x);
  const std::size_t columnsY = across(low.y, body.upperCorner().y);
  std::vector<std::vector<Sphere>> columns(columnsX * columnsY);
  const auto columnOf = [&](const Sphere& s) {
    const auto i = static_cast<std::size_t>(std::max(0.0, (s.x - low.x) / width)) + 1;
    const auto j = static_cast<std::size_t>(std::max(0.0, (s.y - low.y) / width)) + 1;
    return std::pair(std::min(i, columnsX - 2), std::min(j, columnsY - 2));
  };
  for (const auto& sphere : spheres) {
    const auto [i, j] = columnOf(sphere);
    columns[j * columnsX + i].push_back(sphere);
  }
  for (auto& column : columns) {
    std::ranges::sort(column, [](const Sphere& a, const Sphere& b) { return a.z < b.z; });
  }
  for (const auto& sphere : spheres) {
    const auto [i, j] = columnOf(sphere);
    for (std::size_t b = j - 1; b <= j + 1; ++b) {
      for (std::size_t a = i - 1; a <= i + 1; ++a) {
        const auto& column = columns[b * columnsX + a];
        auto other = std::lower_bound(
            column.begin(), column.end(), sphere.z - width, [](const Sphere& s, double z) {
              return s.z < z;
            });
        for (; other != column.end() && other->z <= sphere.z; ++other) {
          const bool isItself = other->x == sphere.x && other->y == sphere.y &&
                                other->z == sphere.z && other->radius == sphere.radius;
          if (isItself) continue;
          const double reach = static_cast<double>(sphere.radius) + other->radius;
          const double gap = length(sphere.centre() - other->centre());
          const double smaller = std::min(sphere.radius, other->radius);
          flaws.overlap = std::max(flaws.overlap, (reach - gap) / smaller);
        }
      }
    }
  }
  return flaws;
}

}  // namespace haptics::reaming
