#pragma once

#include <memory>
#include <vector>

#include "haptics/engine/scene_spec.h"
#include "haptics/reaming/packing/packed_bone.h"

namespace haptics::engine {

/// The punch's three renderings as the published study had them, with N elements.
InterpolationSpec publishedInterpolation();
FiniteElementsSpec publishedElements(int elements);
KalmanSpec publishedFilter(models::KalmanScheme scheme, int elements);

/// A parametric reaming material, for a study that has no measured one: not a measurement.
///
/// It has only the features that the reaming paper reports of its 62 series: almost no force over
/// the first millimetres while the reamer keeps up with the feed, one local peak, then a rise; the
/// upper curve ends at the 800 N at which the static tests stopped, the lower one at 60 N. Depth in
/// [m], forces in [N], torques in [N·m].
std::vector<MaterialNode> parametricMaterial();

/// A parametric cup, 20,000 spheres that feel like parametricMaterial(). Built when it is
/// first asked for, in about a second; any thread.
std::shared_ptr<const reaming::PackedBone> parametricBone();

/// The curves of parametricMaterial(): lower, halfway, upper.
reaming::HardnessCurves parametricCurves();
/// The same of its torque [N·m].
reaming::HardnessCurves parametricTorque();

}  // namespace haptics::engine
