#pragma once

#include "haptics/reaming/bone/sphere_field.h"

namespace haptics::reaming {

/// The one way that the experiment knows: a reamer along +z through the origin of the bone's frame,
/// from just before it first touches (reaming paper, "Experimental setup").
struct Plunge {
  double radius = 0.026;  ///< of the reamer [m]
  double start = 0.0;     ///< z of its centre at a depth of 0 [m]

  Reamer at(double depth) const noexcept { return {radius, {0.0, 0.0, start + depth}}; }
};

/// The plunge that begins 10 µm before the reamer first touches a sphere of @p field.
/// @throws std::invalid_argument  if it never does.
Plunge plungeInto(const SphereField& field, double radius);

}  // namespace haptics::reaming
