#pragma once

#include <memory>

#include "haptics/reaming/packing/packed_bone.h"

namespace haptics::engine {

/// A cup of our own making, 20,000 spheres that feel like parametricMaterial(). Built when it is
/// first asked for, in about a second; any thread.
std::shared_ptr<const reaming::PackedBone> parametricBone();

/// The curves of parametricMaterial(): lower, halfway, upper.
reaming::HardnessCurves parametricCurves();

}  // namespace haptics::engine
