#include "haptics/engine/published_punch.h"

#include "haptics/recordings/cut.h"

namespace haptics::engine {

InterpolationSpec publishedInterpolation() {
  InterpolationSpec spec;
  const auto cut = recordings::parametricCut();
  for (const auto& node : cut.curve.nodes()) spec.curve.push_back({node.travel, node.force});
  return spec;
}

FiniteElementsSpec publishedElements(int elements) {
  FiniteElementsSpec spec;
  spec.parameters.elements = elements;
  return spec;
}

KalmanSpec publishedFilter(models::KalmanScheme scheme, int elements) {
  return {
      .interpolation = publishedInterpolation(),
      .finiteElements = publishedElements(elements),
      .noise = models::KalmanNoise<double>::published(models::ProcessReading::StateOrder),
      .scheme = scheme};
}

}  // namespace haptics::engine
