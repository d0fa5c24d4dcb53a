#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "haptics/engine/built_in_models.h"
#include "haptics/engine/model_names.h"
#include "protocols/model/messages.h"
#include "protocols/reading/cut_file.h"
#include "protocols/reading/material_file.h"
#include "protocols/reading/protocol_parts.h"
#include "protocols/reading/referenced_files.h"

namespace protocols {
namespace {

using questionnaires::Choice;
using questionnaires::Node;
namespace engine = haptics::engine;
namespace models = haptics::models;

/// A complete model; std::nullopt if there is a problem.
template <typename Spec>
using MaybeSpec = std::optional<Spec>;

constexpr auto kDefaultProcessNoise = models::ProcessNoiseReading::StateOrder;
using haptics::reaming::TestSet;

/// The function that reads a model; there is one for each model. A registered model without this
/// function does not compile.
template <typename Spec>
MaybeSpec<Spec> readModel(const Node& parameters, SceneSources& sources) = delete;

/// Sets the branches of a cut, with the protocol's slope limit.
void useCut(const haptics::recordings::Cut& cut, engine::InterpolationSpec& spec) {
  using haptics::recordings::ForceCurve;
  const auto curveOf = [&](const ForceCurve& recorded) {
    return nodesOf(
        spec.slopeLimit ? haptics::recordings::limitSlope(recorded, *spec.slopeLimit).curve
                        : recorded);
  };
  spec.curve = curveOf(cut.curve);
  const bool isBothWays = spec.branches == engine::Branches::Hysteresis;
  if (isBothWays && cut.opening) spec.opening = curveOf(*cut.opening);
}

/// The difference between the largest and the smallest force of a curve [N].
double swingOf(const std::vector<models::CurveNode<double>>& curve) {
  const auto [least, most] = std::ranges::minmax(curve, {}, &models::CurveNode<double>::force);
  return most.force - least.force;
}

/// Warns if the slope limit takes more than half of what the force of @p cut rises.
void adviseOnSlopeLimit(
    const Node& node, const haptics::recordings::Cut& cut, const engine::InterpolationSpec& spec) {
  if (!spec.slopeLimit) return;
  const double recorded = swingOf(nodesOf(cut.curve));
  const double limited = swingOf(spec.curve);
  if (limited >= 0.5 * recorded) return;
  const auto inNewtons = [](double force) {
    return questionnaires::shown(std::round(force * 100.0) / 100.0);
  };
  node.warn(
      "slope_limit",
      message("slope_limit_flattens", inNewtons(limited), inNewtons(recorded)),
      message("slope_limit_flattens.fix"));
}

/// @param defaultExtrapolation  extrapolation if the file does not set it.
MaybeSpec<engine::InterpolationSpec> readInterpolation(
    const Node& node, SceneSources& sources, models::Extrapolation defaultExtrapolation) {
  engine::InterpolationSpec spec;
  spec.options.extrapolation = defaultExtrapolation;
  if (!node.isObjectWithOnlyKeys(
          {"cut", "beyond", "ramp_length", "branches", "turning_width", "slope_limit"})) {
    return std::nullopt;
  }
  const std::string name = node.has("cut") ? node.text("cut") : std::string(kParametricCut);
  spec.options.extrapolation =
      node.choice("beyond", engine::kExtrapolationNames, spec.options.extrapolation);
  spec.options.rampLength = node.number("ramp_length", 0.001, 100.0, spec.options.rampLength);
  spec.branches = node.choice("branches", engine::kBranchesNames, spec.branches);
  spec.transitionWidth = node.number("turning_width", 0.001, 100.0, spec.transitionWidth);
  if (node.has("slope_limit")) spec.slopeLimit = node.number("slope_limit", 0.001, 1e6);
  const auto* cut = sources.cut(name, node.pathOf("cut"));
  if (cut == nullptr) return std::nullopt;
  useCut(*cut, spec);
  if (sources.defaults() != Defaults::Release01) adviseOnSlopeLimit(node, *cut, spec);
  return spec;
}

template <>
MaybeSpec<engine::FiniteElementsSpec> readModel(const Node& node, SceneSources& /*sources*/) {
  engine::FiniteElementsSpec spec;
  auto& p = spec.parameters;
  if (!node.isObjectWithOnlyKeys(
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
    return std::nullopt;
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
  p.weights = node.choice("weights", engine::kToolInterpolationNames, p.weights);
  p.yielding = node.choice("yielding", engine::kYieldLawNames, p.yielding);
  return spec;
}

/// Refuses numbers beside the process noise "as printed", because this noise has the numbers of the
/// paper.
void refuseNumbersBesideAsPrinted(const Node& node) {
  for (const auto* key : {"process_force", "process_covariance", "process_stiffness"}) {
    if (!node.has(key)) continue;
    node.problem(key, "the process noise is as printed, and has its numbers", "remove it");
  }
}

void readNoise(const Node& node, engine::KalmanSpec& spec) {
  if (!node.isObjectWithOnlyKeys(
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
  const auto reading = node.choice("process", engine::kProcessNames, kDefaultProcessNoise);
  auto noise = models::KalmanNoise<double>::published(reading);
  spec.isProcessAsPrinted = reading == models::ProcessNoiseReading::AsPrinted;
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

template <>
MaybeSpec<engine::KalmanSpec> readModel(const Node& node, SceneSources& sources) {
  engine::KalmanSpec spec{
      .noise = models::KalmanNoise<double>::published(kDefaultProcessNoise),
      .scheme = models::KalmanScheme::SpaceDomain};
  if (!node.isObjectWithOnlyKeys(
          {"variant", "interpolation", "finite_elements", "noise", "smoothing"})) {
    return std::nullopt;
  }
  spec.scheme = node.choice("variant", engine::kSchemeNames, spec.scheme);
  spec.smoothing = node.choice("smoothing", engine::kSmoothingNames, spec.smoothing);
  const auto defaultExtrapolation = sources.defaults() == Defaults::Release01
                                        ? models::Extrapolation::RampOut
                                        : models::Extrapolation::Absent;
  MaybeSpec<engine::InterpolationSpec> interpolation;
  if (const auto part = node.object("interpolation")) {
    interpolation = readInterpolation(*part, sources, defaultExtrapolation);
  } else {
    interpolation.emplace().options.extrapolation = defaultExtrapolation;
    useCut(*sources.cut(std::string(kParametricCut), {}), *interpolation);
  }
  MaybeSpec<engine::FiniteElementsSpec> elements = engine::FiniteElementsSpec{};
  if (const auto part = node.object("finite_elements"))
    elements = readModel<engine::FiniteElementsSpec>(*part, sources);
  if (const auto part = node.object("noise")) readNoise(*part, spec);
  if (!interpolation || !elements) return std::nullopt;
  spec.interpolation = std::move(*interpolation);
  spec.finiteElements = std::move(*elements);
  return spec;
}

/// Refuses keys that are only valid with a fitted material.
void refuseWithoutMaterial(const Node& node) {
  const std::pair<const char*, const char*> keys[]{
      {"test_set", "only a fitted material has test sets"},
      {"jitter", "only a fitted material has a measured jitter"},
      {"jitter_seed", "only a fitted material has a measured jitter"}};
  for (const auto& [key, why] : keys) {
    if (node.has(key)) node.problem(key, why, "name a 'material', or remove it");
  }
}

/// Copies the curves of a fitted material to @p spec; false, with a problem, if the material has
/// none.
bool useMaterial(const Node& node, SceneSources& sources, engine::MaterialSpec& spec) {
  const auto name = node.text("material");
  const auto set = node.choice("test_set", kTestSetChoices, TestSet::Dynamic1);
  // static tests press on bone without removing it
  if (set == TestSet::Static) spec.isRemoved = false;
  const bool hasJitter = node.flag("jitter", false);
  spec.jitterSeed = static_cast<std::uint64_t>(node.wholeNumber("jitter_seed", 1, 1'000'000, 1));
  if (node.has("nodes")) {
    node.problem(
        "nodes", "the bone has a material and nodes of its own as well", "keep one of the two");
  }
  const auto [material, curves] = sources.material(name, set, node.pathOf("material"));
  if (material != nullptr && curves == nullptr) {
    node.problem(
        "material",
        "'" + questionnaires::shown(name) + "' has no test set '" + std::string(nameOf(set)) + "'",
        "choose another 'test_set'");
  }
  if (curves == nullptr) return false;
  spec.curves = curves->force;
  spec.torque = curves->torque;
  spec.isMeasured = !material->isSynthetic;
  if (hasJitter) spec.jitter = curves->jitter;
  return true;
}

template <>
MaybeSpec<engine::MaterialSpec> readModel(const Node& node, SceneSources& sources) {
  engine::MaterialSpec spec{.nodes = engine::parametricMaterial()};
  if (!node.isObjectWithOnlyKeys(
          {"hardness",
           "force_scale",
           "removal",
           "nodes",
           "material",
           "test_set",
           "jitter",
           "jitter_seed"})) {
    return std::nullopt;
  }
  spec.isRemoved = sources.defaults() != Defaults::Release01;
  spec.hardness = node.number("hardness", 0.0, 1.0);
  spec.forceScale = node.number("force_scale", 0.001, 1.0, spec.forceScale);
  if (node.has("material")) {
    const bool hasCurves = useMaterial(node, sources, spec);
    spec.isRemoved = node.flag("removal", spec.isRemoved);
    return hasCurves ? MaybeSpec<engine::MaterialSpec>(spec) : std::nullopt;
  }
  spec.isRemoved = node.flag("removal", spec.isRemoved);
  refuseWithoutMaterial(node);
  if (!node.has("nodes")) {
    sources.addParametricMaterial();
    return spec;
  }
  spec.nodes.clear();
  for (const auto& entry : node.requiredList("nodes")) {
    if (!entry.isObjectWithOnlyKeys({"depth_m", "lower_n", "upper_n", "lower_nm", "upper_nm"}))
      continue;
    spec.nodes.push_back(
        {entry.number("depth_m", 0.0, 1.0),
         entry.number("lower_n", 0.0, 1e5),
         entry.number("upper_n", 0.0, 1e5),
         entry.number("lower_nm", 0.0, 1e5, 0.0),
         entry.number("upper_nm", 0.0, 1e5, 0.0)});
  }
  return spec;
}

template <>
MaybeSpec<engine::PackingSpec> readModel(const Node& node, SceneSources& sources) {
  engine::PackingSpec spec;
  if (!node.isObjectWithOnlyKeys(
          {"hardness",
           "force_scale",
           "packing",
           "removal",
           "coupling_n_per_m",
           "cutting_damping",
           "friction"})) {
    return std::nullopt;
  }
  spec.hardness = node.number("hardness", 0.0, 1.0);
  spec.forceScale = node.number("force_scale", 0.001, 1.0, spec.forceScale);
  const auto name = node.has("packing") ? node.text("packing") : std::string(kParametricBone);
  spec.isRemoved = node.flag("removal", spec.isRemoved);
  auto& options = spec.options;
  for (const auto* key : {"coupling_n_per_m", "cutting_damping"}) {
    if (spec.isRemoved || !node.has(key)) continue;
    node.problem(key, "only a bone that is removed has it", "remove it, or set 'removal' to true");
  }
  options.coupling = node.number("coupling_n_per_m", 100.0, 1e6, options.coupling);
  options.cuttingDamping = node.number("cutting_damping", 0.0, 1e6, options.cuttingDamping);
  spec.bone = sources.packing(name, node.pathOf("packing"));
  if (spec.bone == nullptr) return std::nullopt;
  options.friction = spec.bone->friction.value_or(options.friction);
  options.friction = node.number("friction", 0.0, 2.0, options.friction);
  return spec;
}

template <>
MaybeSpec<engine::InterpolationSpec> readModel(const Node& node, SceneSources& sources) {
  auto spec = readInterpolation(node, sources, models::Extrapolation::RampOut);
  if (spec && spec->options.extrapolation == models::Extrapolation::Absent) {
    node.problem(
        "beyond",
        "without the recording nothing would be felt: only a filter has another force",
        "take \"ramp-out\", or the model \"kalman\"");
  }
  return spec;
}

/// @param defaults  for a scene without "reamer".
engine::Reamer readReamer(const Node& scene, Defaults defaults) {
  engine::Reamer reamer;
  const auto node = scene.object("reamer");
  if (!node) return defaults == Defaults::Release01 ? engine::Reamer::withoutFeedLimit() : reamer;
  if (!node->isObjectWithOnlyKeys({"speed", "teeth", "feed_per_tooth"})) return reamer;
  constexpr double kMost = engine::Reamer::kMostSpeed;
  constexpr double kMillimetre = 1e-3;
  reamer.speed = node->number("speed", -kMost, kMost, reamer.speed);
  reamer.teeth = static_cast<int>(node->wholeNumber("teeth", 1, 200, reamer.teeth));
  reamer.feedPerTooth =
      kMillimetre * node->number("feed_per_tooth", 0.001, 10.0, reamer.feedPerTooth / kMillimetre);
  return reamer;
}

using ReadModel = MaybeSpec<engine::ModelSpec> (*)(const Node&, SceneSources&);

template <typename... Spec>
constexpr auto readersOf(std::type_identity<std::variant<Spec...>>) {
  return std::array{Choice<ReadModel>{
      Spec::kInfo.name,
      [](const Node& node, SceneSources& sources) -> MaybeSpec<engine::ModelSpec> {
        return readModel<Spec>(node, sources);
      }}...};
}
constexpr auto kModelReaders = readersOf(std::type_identity<engine::ModelSpec>{});

/// Other names of models in the literature, for hints.
constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kOtherNames{
    {{"fem", "finite-elements"}, {"kf", "kalman"}}};

ReadModel readerOf(std::string_view name) {
  return std::ranges::find(kModelReaders, name, &Choice<ReadModel>::name)->value;
}

/// The function that reads the model of a scene. An unknown model is a problem; the model with the
/// most similar name is then used to read the parameters, so that their problems are reported, too.
std::optional<ReadModel> chooseModelReader(const Node& scene) {
  const auto name = scene.member("model");
  const auto written = name && name->isText() ? name->asText() : std::string();
  const auto other = std::ranges::find(
      kOtherNames, written, &std::pair<std::string_view, std::string_view>::first);
  if (other != kOtherNames.end()) {
    scene.problem(
        "model",
        "unknown word '" + written + "'",
        "did you mean '" + std::string(other->second) + "'?");
    return readerOf(other->second);
  }
  if (const auto known = scene.chosen("model", kModelReaders)) return known->value;
  std::vector<std::string_view> names;
  for (const auto& model : kModelReaders) names.push_back(model.name);
  const auto meant = questionnaires::nearest(written, names);
  return meant ? std::optional(readerOf(*meant)) : std::nullopt;
}

}  // namespace

void readScene(const Node& scene, SceneSources& sources, Condition& condition) {
  if (!scene.isObjectWithOnlyKeys(
          {"device",
           "model",
           "parameters",
           "visualisation",
           "tissue_follows",
           "anatomy",
           "reamer"})) {
    return;
  }
  condition.device = scene.id("device");
  condition.isVisualised = scene.flag("visualisation", false);
  condition.tissueDrawing = scene.choice(
      "tissue_follows",
      engine::kTissueDrawingNames,
      sources.defaults() == Defaults::Release01 ? engine::TissueDrawing::Force
                                                : engine::TissueDrawing::Penetration);
  if (scene.has("anatomy")) condition.anatomy = scene.text("anatomy");
  condition.reamer = readReamer(scene, sources.defaults());
  const auto read = chooseModelReader(scene);
  const auto parameters = scene.requiredObject("parameters");
  if (read && parameters) {
    auto model = (*read)(*parameters, sources);
    if (parameters->isSound()) condition.model = std::move(model);
  }
  const bool isBone =
      condition.model && engine::infoOf(*condition.model).tissue == haptics::devices::Tissue::Bone;
  if (condition.model && !isBone && scene.has("reamer")) {
    scene.problem("reamer", "only bone is reamed, and this model is of none", "remove it");
  }
  if (condition.anatomy) {
    condition.knee = sources.anatomy(*condition.anatomy, scene.pathOf("anatomy"));
  }
}

}  // namespace protocols
