#include "study/app/scene_cost.h"

#include <cmath>
#include <functional>
#include <memory>

#include "haptics/engine/built_in_models.h"
#include "haptics/engine/compiled_scene.h"

namespace study::app {
namespace {

namespace timing = haptics::timing;
namespace engine = haptics::engine;

constexpr int kTicksPerFrame = 17;  // for a display with 60 Hz and a loop with 1 kHz

/// Additional work in every tick, computed from travel and force. Its result is used only to
/// prevent the compiler from removing the work.
using ExtraWork = std::function<double(double travel, double force, int tick)>;

timing::Contestant makeContestant(
    const std::string& what, const engine::SceneSpec& spec, double middle, ExtraWork extraWork) {
  auto scene = std::make_shared<engine::CompiledScene>(spec);
  return {what, [scene, middle, extraWork = std::move(extraWork)](int steps) {
            double sum = 0.0;
            for (int i = 0; i < steps; ++i) {
              const double travel = middle * (1.0 - std::cos(0.004 * i));
              const double force = scene->respond({.travel = travel}).force;
              sum += force;
              if (extraWork) sum += extraWork(travel, force, i);
            }
            return sum;
          }};
}

ExtraWork extraModel(const engine::SceneSpec& spec) {
  auto scene = std::make_shared<engine::CompiledScene>(spec);
  return [scene](double travel, double, int) { return scene->respond({.travel = travel}).force; };
}

/// Additional work: the shape of the finite-element mesh, computed every @p every ticks.
ExtraWork extraMesh(const engine::FiniteElementsSpec& spec, int every) {
  struct Mesh {
    std::vector<double> shape;
    std::vector<double> drawn;
  };
  const haptics::models::FiniteElements<double> elements(spec.asParameters());
  auto mesh = std::make_shared<Mesh>();
  mesh->shape.resize(static_cast<std::size_t>(elements.elements()));
  mesh->drawn.resize(mesh->shape.size());
  elements.writeMeshShape(mesh->shape.data());
  return [mesh, every](double, double force, int tick) {
    if (tick % every != 0) return 0.0;
    for (std::size_t i = 0; i < mesh->shape.size(); ++i) mesh->drawn[i] = mesh->shape[i] * force;
    return mesh->drawn.back();
  };
}

/// @param middle  middle of the device's travel [device's travel unit], here and in the functions
///     below.
void addMeniscus(
    const engine::SceneSpec& spec, double middle, std::vector<timing::Contestant>& contestants) {
  const auto add = [&](const char* what, ExtraWork extraWork) {
    contestants.push_back(makeContestant(what, spec, middle, std::move(extraWork)));
  };
  const auto parts = engine::partsOf(spec.model);
  const auto shown = parts.elements != nullptr ? *parts.elements : engine::publishedElements(5);
  add("as it is", nullptr);
  if (parts.cut == nullptr) {
    add("… and the recorded cut", extraModel({.model = engine::publishedInterpolation()}));
  }
  if (parts.elements == nullptr) {
    add("… and finite elements", extraModel({.model = engine::publishedElements(5)}));
  }
  if (parts.filter == nullptr) {
    const auto filter = engine::publishedFilter(haptics::models::KalmanScheme::SpaceDomain, 5);
    add("… and both forces and the filter", extraModel({.model = filter}));
  }
  add("… and the mesh at 60 Hz", extraMesh(shown, kTicksPerFrame));
  add("… and the mesh in every tick", extraMesh(shown, 1));
}

/// Adds a scene with a material's curve, alone and with the additional cost of spheres.
void addMaterial(
    const engine::SceneSpec& spec,
    const engine::MaterialSpec& material,
    double middle,
    std::vector<timing::Contestant>& contestants) {
  const auto add = [&](const char* what, ExtraWork extraWork) {
    contestants.push_back(makeContestant(what, spec, middle, std::move(extraWork)));
  };
  add("as it is", nullptr);
  auto lower = material;
  auto upper = material;
  lower.hardness = 0.0;
  upper.hardness = 1.0;
  add("… and both curves in every tick",
      [low = extraModel({.model = lower}), high = extraModel({.model = upper})](
          double x, double f, int i) { return low(x, f, i) + high(x, f, i); });
  for (const bool isRemoved : {false, true}) {
    const engine::PackingSpec spheres{.bone = engine::parametricBone(), .isRemoved = isRemoved};
    add(isRemoved ? "… and 20,000 spheres that are reamed away" : "… and 20,000 spheres that stay",
        extraModel({.model = spheres}));
  }
}

/// Adds variants of a scene with spheres: with spheres that are removed instead of staying, or vice
/// versa, and with a curve in place of spheres.
void addPacking(
    const engine::PackingSpec& packing,
    double middle,
    std::vector<timing::Contestant>& contestants) {
  const auto add = [&](const char* what, const auto& model) {
    contestants.push_back(makeContestant(what, {.model = model}, middle, nullptr));
  };
  add("as it is", packing);
  auto other = packing;
  other.isRemoved = !packing.isRemoved;
  add(packing.isRemoved ? "spheres that stay" : "spheres that are reamed away", other);
  add("the curve alone", engine::MaterialSpec{.nodes = engine::parametricMaterial()});
}

}  // namespace

std::vector<SceneCost> measureCosts(
    const engine::SceneSpec& spec, const haptics::devices::DeviceKind& kind) {
  const double middle = 0.5 * (kind.travel.least + kind.travel.most);
  std::vector<timing::Contestant> contestants;
  const auto parts = engine::partsOf(spec.model);
  if (parts.packing != nullptr) {
    addPacking(*parts.packing, middle, contestants);
  } else if (parts.material != nullptr) {
    addMaterial(spec, *parts.material, middle, contestants);
  } else {
    addMeniscus(spec, middle, contestants);
  }
  const auto timings = timing::compareTimes(contestants);
  std::vector<SceneCost> costs;
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    costs.push_back({contestants[i].method, timings[i]});
  }
  return costs;
}

}  // namespace study::app
