#pragma once

#include <string>
#include <vector>

#include "haptics/reaming/bone/solid.h"

namespace haptics::reaming {

/// A sphere of a packing, in the numbers in which it is kept.
struct Sphere {
  float x = 0.0F;  ///< [m]
  float y = 0.0F;
  float z = 0.0F;
  float radius = 0.0F;  ///< [m], > 0

  Vec3 centre() const noexcept { return {x, y, z}; }
};

/// A body as spheres that do not overlap (reaming paper, "Implementation approach").
struct Packing {
  std::vector<Sphere> spheres;  ///< from the largest to the smallest
  double volume = 0.0;          ///< of the body [m³]

  double filled() const noexcept;                                 ///< volume of the spheres [m³]
  double coverage() const noexcept { return filled() / volume; }  ///< share of the body
};

/// The worst of a packing, each as a share of a radius: what tests and people ask for.
struct PackingFlaws {
  double overlap = 0.0;     ///< of the smaller of two; 0 where no two overlap
  double protrusion = 0.0;  ///< out of the body
};
PackingFlaws flawsOf(const Packing& packing, const Solid& body);

}  // namespace haptics::reaming
