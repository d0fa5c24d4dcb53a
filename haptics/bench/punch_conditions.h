#pragma once

#include "haptics/engine/scene_spec.h"

namespace haptics::bench {

/// The punch's three renderings as the published study had them, with N elements.
engine::InterpolationSpec publishedInterpolation();
engine::FiniteElementsSpec publishedElements(int elements);
engine::KalmanSpec publishedFilter(models::KalmanScheme scheme, int elements);

}  // namespace haptics::bench
