#include <cmath>

#include "haptics/bench/measurement.h"
#include "haptics/engine/built_in_models.h"
#include "haptics/engine/compiled_scene.h"

namespace haptics::bench {
namespace {

constexpr double kMiddleTravel = 6.0;  // [travel units]

/// Renders a scene along a cut, and computes its mesh in every step, as in the paper's loop.
class RenderedCut {
 public:
  RenderedCut(const char* name, engine::SceneSpec spec, int elements)
      : name_(name),
        scene_(spec),
        elements_(engine::publishedElements(elements).parameters),
        shape_(static_cast<std::size_t>(elements)),
        mesh_(shape_.size()) {
    elements_.writeMeshShape(shape_.data());
  }

  Contestant contestant(bool hasMesh) {
    return {name_ + (hasMesh ? ", with mesh" : ", force alone"), [this, hasMesh](int steps) {
              double sum = 0.0;
              for (int i = 0; i < steps; ++i) {
                const double travel = kMiddleTravel + 5.0 * std::cos(0.004 * i);
                const double force = scene_.respond({.travel = travel}).force;
                sum += force;
                if (!hasMesh) continue;
                for (std::size_t k = 0; k < shape_.size(); ++k) mesh_[k] = shape_[k] * force;
                sum += mesh_.back();
              }
              return sum;
            }};
  }

 private:
  std::string name_;
  engine::CompiledScene scene_;
  models::FiniteElements<double> elements_;
  std::vector<double> shape_;
  std::vector<double> mesh_;
};

}  // namespace

void measureRefresh(const AccuracyRun& run) {
  if (run.isShortRun) return;
  for (const int elements : {5, 10, 15, 100, 1000}) {
    RenderedCut interpolation(
        "interpolation", {.model = engine::publishedInterpolation()}, elements);
    RenderedCut finiteElements(
        "finite elements", {.model = engine::publishedElements(elements)}, elements);
    RenderedCut kalman(
        "Kalman filter",
        {.model = engine::publishedFilter(models::KalmanScheme::AuthorsFirmware, elements)},
        elements);
    std::vector<Contestant> contestants;
    for (auto* felt : {&interpolation, &finiteElements, &kalman}) {
      contestants.push_back(felt->contestant(true));
      contestants.push_back(felt->contestant(false));
    }
    const auto timings = run.times(contestants);
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      run.report(
          {.family = "refresh",
           .setting = "a step",
           .method = contestants[i].method,
           .parameter = static_cast<double>(elements),
           .time = timings[i]});
    }
  }
}

}  // namespace haptics::bench
