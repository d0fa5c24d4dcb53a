#pragma once

#include <array>
#include <optional>

#include "haptics/reaming/bone/packing.h"

namespace haptics::reaming {

/// What a sphere may touch: another sphere, or a plane.
struct Obstacle {
  double distance = 0.0;  ///< from the place it was asked for to its surface [m]; below 0 inside
  Vec3 place;             ///< centre of a sphere, or unit normal of a plane
  double size = 0.0;      ///< radius [m]; of a plane its offset, normal·x
  bool isPlane = false;
};

struct TangentSphere {
  Vec3 centre;
  double radius = 0.0;
};

/// The sphere that touches four obstacles from outside (problem of Apollonius), by Newton's method
/// from @p start; std::nullopt if there is none within @p reach [m] of it.
std::optional<TangentSphere> tangentTo(
    const std::array<Obstacle, 4>& obstacles, Vec3 start, double reach) noexcept;

}  // namespace haptics::reaming
