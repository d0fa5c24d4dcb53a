#include "haptics/bench/punch_conditions.h"

#include "haptics/recordings/parametric_cut.h"

namespace haptics::bench {

engine::InterpolationSpec publishedInterpolation() {
  engine::InterpolationSpec spec;
  const auto cut = recordings::parametricCut();
  for (const auto& node : cut.curve.nodes()) spec.curve.push_back({node.travel, node.force});
  return spec;
}

engine::FiniteElementsSpec publishedElements(int elements) {
  engine::FiniteElementsSpec spec;
  spec.parameters.elements = elements;
  return spec;
}

engine::KalmanSpec publishedFilter(models::KalmanScheme scheme, int elements) {
  return {
      .interpolation = publishedInterpolation(),
      .finiteElements = publishedElements(elements),
      .noise = models::KalmanNoise<double>::published(models::ProcessReading::StateOrder),
      .scheme = scheme};
}

}  // namespace haptics::bench
