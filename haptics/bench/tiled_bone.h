#pragma once

#include <cstddef>

#include "haptics/reaming/bone/packing.h"

namespace haptics::bench {

/// The parametric acetabulum full of copies of one small packed cube, scaled so that about
/// @p count spheres find room: as dense as a packing of its own, and there at once at any size.
reaming::Packing tiledBone(std::size_t count);

}  // namespace haptics::bench
