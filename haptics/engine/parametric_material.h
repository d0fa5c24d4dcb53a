#pragma once

#include <vector>

#include "haptics/engine/scene_spec.h"

namespace haptics::engine {

/// A reaming material of our own making, for a study that has no measured one: not a measurement.
///
/// It has what the reaming paper reports of its 62 series and no more: almost no force over the
/// first millimetres while the reamer keeps up with the feed, one local peak, then a rise; the
/// upper curve ends at the 800 N at which the static tests stopped, the lower one at 60 N. Depth in
/// [m], forces in [N].
std::vector<MaterialNode> parametricMaterial();

}  // namespace haptics::engine
