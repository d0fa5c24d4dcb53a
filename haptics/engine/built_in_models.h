#pragma once

#include <memory>
#include <vector>

#include "haptics/engine/scene_spec.h"
#include "haptics/reaming/packing/packed_bone.h"

namespace haptics::engine {

/// The three renderings of the published punch study.
InterpolationSpec publishedInterpolation();
FiniteElementsSpec publishedElements(int elements);
KalmanSpec publishedFilter(models::KalmanScheme scheme, int elements);

/// A parametric (not measured) reaming material, for a study without a measured one.
///
/// It reproduces what the reaming paper reports about its 62 series: almost no force over the first
/// millimetres, where the reamer keeps up with the feed, then one local peak, then a rise. The
/// upper curve ends at 800 N, where the static tests stopped, the lower one at 60 N. Depth in [m],
/// forces in [N], torques in [N·m].
std::vector<MaterialNode> parametricMaterial();

/// A parametric cup of 20,000 spheres, fitted to the curves of parametricMaterial(). The first call
/// builds it, in about a second. May be called from any thread.
std::shared_ptr<const reaming::PackedBone> parametricBone();

/// The force curves of parametricMaterial() [N]: lower, halfway between both, upper.
reaming::HardnessCurves parametricCurves();
/// The torque curves of parametricMaterial() [N·m]: lower, halfway between both, upper.
reaming::HardnessCurves parametricTorque();

}  // namespace haptics::engine
