#include <array>
#include <type_traits>
#include <variant>

#include "haptics/engine/built_in_models.h"
#include "haptics/engine/model_names.h"
#include "protocols/reading/protocol_file.h"

namespace protocols {
namespace {

using questionnaires::Choice;
using questionnaires::Node;
namespace engine = haptics::engine;
namespace models = haptics::models;

constexpr auto kUsualProcess = models::ProcessReading::StateOrder;
using haptics::reaming::TestSet;
constexpr std::array kTestSets{
    Choice<TestSet>{"static", TestSet::Static},
    Choice<TestSet>{"dynamic-1", TestSet::Dynamic1},
    Choice<TestSet>{"dynamic-2", TestSet::Dynamic2},
};

/// @param beyond  where the file does not say.
engine::InterpolationSpec readInterpolation(
    const Node& node, Condition& condition, models::BeyondCurve beyond) {
  engine::InterpolationSpec spec;
  spec.options.beyond = beyond;
  if (!node.isObjectWith(
          {"cut", "beyond", "ramp_length", "branches", "turning_width", "slope_limit"})) {
    return spec;
  }
  const std::string cut = node.has("cut") ? node.text("cut") : std::string(kParametricCut);
  condition.cut = CutReference{cut, node.pathOf("cut")};
  spec.options.beyond = node.choice("beyond", engine::kBeyondNames, spec.options.beyond);
  spec.options.rampLength = node.number("ramp_length", 0.001, 100.0, spec.options.rampLength);
  spec.branches = node.choice("branches", engine::kBranchesNames, spec.branches);
  spec.turningWidth = node.number("turning_width", 0.001, 100.0, spec.turningWidth);
  if (node.has("slope_limit")) spec.slopeLimit = node.number("slope_limit", 0.001, 1e6);
  return spec;
}

engine::FiniteElementsSpec readFiniteElements(const Node& node) {
  engine::FiniteElementsSpec spec;
  auto& p = spec.parameters;
  if (!node.isObjectWith(
          {"elements",
           "start",
           "end",
           "tool_position",
           "element_stiffness",
           "element_stiffnesses",
           "contact_travel",
           "yield_force_n",
           "boundary",
           "weights",
           "yielding"})) {
    return spec;
  }
  constexpr double kSoftest = 1e-6;
  constexpr double kStiffest = 1e6;
  p.elements = static_cast<int>(node.wholeNumber("elements", 1, 100'000, p.elements));
  p.start = node.number("start", -1e6, 1e6, p.start);
  p.end = node.number("end", -1e6, 1e6, p.end);
  p.toolPosition = node.number("tool_position", -1e6, 1e6, p.toolPosition);
  p.elementStiffness = node.number("element_stiffness", kSoftest, kStiffest, p.elementStiffness);
  if (node.has("element_stiffnesses")) {
    node.requiredList("element_stiffnesses");
    spec.elementStiffnesses = node.numbers("element_stiffnesses", kSoftest, kStiffest);
    if (node.has("element_stiffness")) {
      node.problem(
          "element_stiffness",
          "the elements have one stiffness and a list of their own as well",
          "keep one of the two");
    }
  }
  p.contact = node.number("contact_travel", -1000.0, 1000.0, p.contact);
  p.yieldForce = node.number("yield_force_n", 0.0, 1000.0, p.yieldForce);
  p.boundary = node.choice("boundary", engine::kBoundaryNames, p.boundary);
  p.weights = node.choice("weights", engine::kWeightsNames, p.weights);
  p.yielding = node.choice("yielding", engine::kYieldingNames, p.yielding);
  return spec;
}

/// What is printed stays as it is printed.
void refuseNumbersBesideAsPrinted(const Node& node) {
  for (const auto* key : {"process_force", "process_covariance", "process_stiffness"}) {
    if (!node.has(key)) continue;
    node.problem(key, "the process noise is as printed, and has its numbers", "remove it");
  }
}

void readNoise(const Node& node, engine::KalmanSpec& spec) {
  if (!node.isObjectWith(
          {"process",
           "process_force",
           "process_covariance",
           "process_stiffness",
           "finite_elements",
           "interpolation",
           "wandering"})) {
    return;
  }
  constexpr double kMost = 1e9;
  const auto reading = node.choice("process", engine::kProcessNames, kUsualProcess);
  auto noise = models::KalmanNoise<double>::published(reading);
  spec.isProcessAsPrinted = reading == models::ProcessReading::AsPrinted;
  if (spec.isProcessAsPrinted) refuseNumbersBesideAsPrinted(node);
  noise.processForce = node.number("process_force", 0.0, kMost, noise.processForce);
  noise.processCovariance =
      node.number("process_covariance", -kMost, kMost, noise.processCovariance);
  noise.processStiffness = node.number("process_stiffness", 0.0, kMost, noise.processStiffness);
  noise.finiteElements = node.number("finite_elements", 0.0, kMost, noise.finiteElements);
  noise.interpolation = node.number("interpolation", 0.0, kMost, noise.interpolation);
  noise.wandering = node.number("wandering", 0.0, kMost, noise.wandering);
  spec.noise = noise;
}

engine::KalmanSpec readKalman(const Node& node, Condition& condition) {
  engine::KalmanSpec spec{
      .noise = models::KalmanNoise<double>::published(kUsualProcess),
      .scheme = models::KalmanScheme::SpaceDomain};
  if (!node.isObjectWith({"variant", "interpolation", "finite_elements", "noise", "smoothing"})) {
    return spec;
  }
  spec.scheme = node.choice("variant", engine::kSchemeNames, spec.scheme);
  spec.smoothing = node.choice("smoothing", engine::kSmoothingNames, spec.smoothing);
  condition.cut = CutReference{std::string(kParametricCut), node.pathOf("interpolation.cut")};
  spec.interpolation.options.beyond = models::BeyondCurve::Absent;
  if (const auto part = node.object("interpolation")) {
    spec.interpolation = readInterpolation(*part, condition, models::BeyondCurve::Absent);
  }
  if (const auto part = node.object("finite_elements")) {
    spec.finiteElements = readFiniteElements(*part);
  }
  if (const auto part = node.object("noise")) readNoise(*part, spec);
  return spec;
}

/// What only a fitted material has.
void refuseWithoutMaterial(const Node& node) {
  const std::pair<const char*, const char*> keys[]{
      {"test_set", "only a fitted material has test sets"},
      {"jitter", "only a fitted material has a measured jitter"},
      {"jitter_seed", "only a fitted material has a measured jitter"}};
  for (const auto& [key, why] : keys) {
    if (node.has(key)) node.problem(key, why, "name a 'material', or remove it");
  }
}

engine::MaterialSpec readMaterial(const Node& node, Condition& condition) {
  engine::MaterialSpec spec{.nodes = engine::parametricMaterial()};
  if (!node.isObjectWith(
          {"hardness", "force_scale", "nodes", "material", "test_set", "jitter", "jitter_seed"})) {
    return spec;
  }
  spec.hardness = node.number("hardness", 0.0, 1.0);
  spec.forceScale = node.number("force_scale", 0.001, 1.0, spec.forceScale);
  if (node.has("material")) {
    condition.material = MaterialReference{
        node.text("material"),
        node.choice("test_set", kTestSets, haptics::reaming::TestSet::Dynamic1),
        node.flag("jitter", false),
        node.pathOf("material")};
    spec.jitterSeed = static_cast<std::uint64_t>(node.wholeNumber("jitter_seed", 1, 1'000'000, 1));
    if (node.has("nodes")) {
      node.problem(
          "nodes", "the bone has a material and nodes of its own as well", "keep one of the two");
    }
  } else {
    refuseWithoutMaterial(node);
  }
  condition.hasOwnMaterial = !node.has("material") && !node.has("nodes");
  if (!node.has("nodes")) return spec;
  spec.nodes.clear();
  for (const auto& entry : node.requiredList("nodes")) {
    if (!entry.isObjectWith({"depth_m", "lower_n", "upper_n"})) continue;
    spec.nodes.push_back(
        {entry.number("depth_m", 0.0, 1.0),
         entry.number("lower_n", 0.0, 1e5),
         entry.number("upper_n", 0.0, 1e5)});
  }
  return spec;
}

engine::PackingSpec readPacking(const Node& node, Condition& condition) {
  engine::PackingSpec spec;
  if (!node.isObjectWith(
          {"hardness",
           "force_scale",
           "packing",
           "removal",
           "coupling_n_per_m",
           "cutting_damping",
           "friction"})) {
    return spec;
  }
  spec.hardness = node.number("hardness", 0.0, 1.0);
  spec.forceScale = node.number("force_scale", 0.001, 1.0, spec.forceScale);
  condition.packing = PackingReference{
      node.has("packing") ? node.text("packing") : std::string(kParametricBone),
      node.pathOf("packing")};
  spec.isRemoved = node.flag("removal", spec.isRemoved);
  auto& options = spec.options;
  for (const auto* key : {"coupling_n_per_m", "cutting_damping", "friction"}) {
    if (spec.isRemoved || !node.has(key)) continue;
    node.problem(key, "only a bone that is removed has it", "remove it, or set 'removal' to true");
  }
  options.coupling = node.number("coupling_n_per_m", 100.0, 1e6, options.coupling);
  options.cuttingDamping = node.number("cutting_damping", 0.0, 1e6, options.cuttingDamping);
  options.friction = node.number("friction", 0.0, 2.0, options.friction);
  return spec;
}

/// The reader of each model; one that is registered and has none does not compile.
template <typename Spec>
engine::ModelSpec readModel(const Node& parameters, Condition& condition) = delete;
template <>
engine::ModelSpec readModel<engine::InterpolationSpec>(const Node& node, Condition& condition) {
  auto spec = readInterpolation(node, condition, models::BeyondCurve::RampOut);
  if (spec.options.beyond == models::BeyondCurve::Absent) {
    node.problem(
        "beyond",
        "without the recording nothing would be felt: only a filter has another force",
        "take \"ramp-out\", or the model \"kalman\"");
  }
  return spec;
}
template <>
engine::ModelSpec readModel<engine::FiniteElementsSpec>(const Node& node, Condition&) {
  return readFiniteElements(node);
}
template <>
engine::ModelSpec readModel<engine::KalmanSpec>(const Node& node, Condition& condition) {
  return readKalman(node, condition);
}
template <>
engine::ModelSpec readModel<engine::MaterialSpec>(const Node& node, Condition& condition) {
  return readMaterial(node, condition);
}
template <>
engine::ModelSpec readModel<engine::PackingSpec>(const Node& node, Condition& condition) {
  return readPacking(node, condition);
}

using ReadModel = engine::ModelSpec (*)(const Node&, Condition&);

template <typename... Spec>
constexpr auto readersOf(std::type_identity<std::variant<Spec...>>) {
  return std::array{Choice<ReadModel>{Spec::kFacts.name, readModel<Spec>}...};
}
constexpr auto kModels = readersOf(std::type_identity<engine::ModelSpec>{});

}  // namespace

void readScene(const Node& scene, Condition& condition) {
  if (!scene.isObjectWith(
          {"device", "model", "parameters", "visualisation", "tissue_follows", "anatomy"}))
    return;
  condition.device = scene.id("device");
  condition.scene.isVisualised = scene.flag("visualisation", false);
  condition.scene.seenTissue =
      scene.choice("tissue_follows", engine::kSeenTissueNames, engine::SeenTissue::Penetration);
  if (scene.has("anatomy")) {
    condition.anatomy = AnatomyReference{scene.text("anatomy"), scene.pathOf("anatomy")};
  }
  const auto model = readChoice(scene, "model", kModels);
  const auto parameters = scene.requiredObject("parameters");
  if (model && parameters) condition.scene.model = (*model)(*parameters, condition);
}

}  // namespace protocols
