#include "haptics/reaming/packing/tangent_sphere.h"

#include <cmath>
#include <utility>

namespace haptics::reaming {
namespace {

/// Four linear equations in four unknowns, with the right-hand side.
using System = std::array<std::array<double, 5>, 4>;

/// Gauss–Jordan elimination with pivoting; returns false if the system is singular. The right-hand
/// side becomes the solution.
bool solve(System& a) noexcept {
  constexpr double kLeastPivot = 1e-6;  // relative to the unit normals in the equations
  for (std::size_t column = 0; column < 4; ++column) {
    std::size_t best = column;
    for (std::size_t row = column + 1; row < 4; ++row) {
      if (std::abs(a[row][column]) > std::abs(a[best][column])) best = row;
    }
    if (!(std::abs(a[best][column]) > kLeastPivot)) return false;
    std::swap(a[column], a[best]);
    for (std::size_t row = 0; row < 4; ++row) {
      if (row == column) continue;
      const double factor = a[row][column] / a[column][column];
      for (std::size_t k = column; k < 5; ++k) a[row][k] -= factor * a[column][k];
    }
  }
  for (std::size_t row = 0; row < 4; ++row) a[row][4] /= a[row][row];
  return true;
}

/// Computes the distance of @p from from an obstacle's surface, and its gradient; false if the
/// gradient is undefined.
bool distanceAndNormal(
    const Obstacle& obstacle, Vec3 from, double& distance, Vec3& normal) noexcept {
  if (obstacle.isPlane) {
    normal = obstacle.place;
    distance = dot(normal, from) - obstacle.size;
    return true;
  }
  const Vec3 away = from - obstacle.place;
  const double gap = length(away);
  if (!(gap > 0.0)) return false;
  normal = (1.0 / gap) * away;
  distance = gap - obstacle.size;
  return true;
}

}  // namespace

std::optional<TangentSphere> tangentTo(
    const std::array<Obstacle, 4>& obstacles, Vec3 start, double reach) noexcept {
  // Unknowns are the centre c and the radius r: dᵢ(c) − r = 0 for the signed distance dᵢ to each
  // obstacle. Its derivative by c is the unit normal, so a row of Newton's system is
  // nᵢ·Δc − Δr = r − dᵢ.
  constexpr int kMostSteps = 8;        // the method converges quadratically or not at all
  constexpr double kTolerance = 1e-7;  // relative to the reach
  TangentSphere sphere{start, obstacles[0].distance};
  for (int step = 0; step < kMostSteps; ++step) {
    System system;
    for (std::size_t i = 0; i < 4; ++i) {
      Vec3 normal;
      double distance = 0.0;
      if (!distanceAndNormal(obstacles[i], sphere.centre, distance, normal)) return std::nullopt;
      system[i] = {normal.x, normal.y, normal.z, -1.0, sphere.radius - distance};
    }
    if (!solve(system)) return std::nullopt;
    const Vec3 move{system[0][4], system[1][4], system[2][4]};
    sphere.centre = sphere.centre + move;
    sphere.radius += system[3][4];
    const double moved = length(move);
    // A step that leaves the neighbourhood finds a sphere between other obstacles, or none. The
    // negated comparisons also catch NaN.
    if (!(moved < reach) || !(length(sphere.centre - start) < 2.0 * reach)) return std::nullopt;
    if (moved < kTolerance * reach) return sphere;
  }
  return std::nullopt;
}

}  // namespace haptics::reaming
