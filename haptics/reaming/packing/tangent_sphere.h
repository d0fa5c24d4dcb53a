#pragma once

#include <array>
#include <optional>

#include "haptics/reaming/bone/packing.h"

namespace haptics::reaming {

/// An obstacle that a sphere may touch: another sphere or a plane.
struct Obstacle {
  double distance = 0.0;  ///< from a given point to the obstacle's surface [m]; negative inside
  Vec3 place;             ///< centre of the sphere, or unit normal of the plane
  double size = 0.0;      ///< radius of the sphere, or offset normal·x of the plane [m]
  bool isPlane = false;
};

struct TangentSphere {
  Vec3 centre;
  double radius = 0.0;
};

/// The sphere that touches four obstacles from outside (problem of Apollonius), by Newton's method
/// from @p start; std::nullopt if none is found within 2 · @p reach [m] of @p start.
std::optional<TangentSphere> tangentTo(
    const std::array<Obstacle, 4>& obstacles, Vec3 start, double reach) noexcept;

}  // namespace haptics::reaming
