#pragma once

#include "haptics/engine/scene_spec.h"

namespace haptics::engine {

/// The punch's three renderings as the published study had them, with N elements.
InterpolationSpec publishedInterpolation();
FiniteElementsSpec publishedElements(int elements);
KalmanSpec publishedFilter(models::KalmanScheme scheme, int elements);

}  // namespace haptics::engine
