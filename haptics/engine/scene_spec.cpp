#include "haptics/engine/scene_spec.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "haptics/engine/bone_models.h"
#include "haptics/reaming/packing/packed_bone.h"

namespace haptics::engine {
namespace {

using Problems = std::vector<std::string>;

void check(const InterpolationSpec& spec, Problems& problems) {
  using Model = models::Interpolation<double>;
  if (!Model::isSound(spec.curve.data(), spec.curve.size(), spec.options)) {
    problems.push_back(
        "the force curve needs two or more points with strictly increasing travel, finite forces "
        "and finite slopes, and a ramp longer than 0");
  }
  if (spec.branches == Branches::ClosingOnly) return;
  if (spec.opening.empty()) {
    problems.push_back(
        "hysteresis needs the opening branch of the cut, and this cut has none; import the "
        "recording again, or take closing-only");
  } else if (!Model::isSound(spec.opening.data(), spec.opening.size(), spec.options)) {
    problems.push_back(
        "the opening branch needs two or more points with strictly increasing travel, finite "
        "forces and finite slopes");
  }
  if (!(spec.transitionWidth > 0.0) || !std::isfinite(spec.transitionWidth)) {
    problems.push_back("the width of travel between the branches must be a number above 0");
  }
}

void check(const FiniteElementsSpec& spec, Problems& problems) {
  using Model = models::FiniteElements<double>;
  const auto& each = spec.elementStiffnesses;
  if (!each.empty() && each.size() != static_cast<std::size_t>(spec.parameters.elements)) {
    problems.push_back(
        "there are " + std::to_string(spec.parameters.elements) + " finite elements, but " +
        std::to_string(each.size()) + " stiffnesses");
    return;
  }
  auto withPapersWeights = spec.asParameters();
  withPapersWeights.weights = models::ToolInterpolation::Paper;
  if (!Model::isSound(withPapersWeights)) {
    problems.push_back(
        "the finite elements need start < tool position < end, one or more elements, a stiffness "
        "above 0 and a yield force that is not negative");
  } else if (!Model::isSound(spec.asParameters())) {
    problems.push_back(
        "the tool presses on the last finite element, where the authors' firmware writes beyond "
        "its memory; move it, or take the paper's weights");
  }
}

void check(const KalmanSpec& spec, Problems& problems) {
  check(spec.interpolation, problems);
  check(spec.finiteElements, problems);
  if (const char* why = spec.noise.invalidReason()) problems.emplace_back(why);
  const bool isPerStep = spec.scheme != models::KalmanScheme::SpaceDomain;
  if (spec.isProcessAsPrinted && !isPerStep) {
    problems.emplace_back("the printed process noise is one per step; take another variant");
  }
}

void checkScale(double hardness, double forceScale, Problems& problems) {
  if (!(hardness >= 0.0 && hardness <= 1.0)) {
    problems.push_back("the hardness must lie between 0 and 1");
  }
  if (!(forceScale > 0.0 && forceScale <= 1.0)) {
    problems.push_back("the force scale must lie above 0 and not above 1");
  }
}

void check(const MaterialSpec& spec, Problems& problems) {
  checkScale(spec.hardness, spec.forceScale, problems);
  const bool isFitted = !spec.curves.isEmpty();
  if (isFitted) {
    if (const auto problem = reaming::problemOf(spec.curves)) problems.push_back(*problem);
    const auto problem = spec.torque.isEmpty() ? std::nullopt : reaming::problemOf(spec.torque);
    if (problem) problems.push_back(*problem + ", in its torque");
  } else if (spec.nodes.size() < 2) {
    problems.push_back("the material needs two or more nodes");
  }
  for (std::size_t i = 0; i < spec.nodes.size(); ++i) {
    const auto& node = spec.nodes[i];
    const std::string name = "material node " + std::to_string(i + 1);
    if (!std::isfinite(
            node.depth + node.lower + node.upper + node.lowerTorque + node.upperTorque)) {
      problems.push_back(name + " is not a finite number");
    } else if (!(node.lower >= 0.0 && node.lower <= node.upper)) {
      problems.push_back(name + ": 0 ≤ lower ≤ upper must hold");
    } else if (!(node.lowerTorque >= 0.0 && node.lowerTorque <= node.upperTorque)) {
      problems.push_back(name + ": 0 ≤ lower ≤ upper must hold of the torque, too");
    }
    if (i > 0 && !(node.depth > spec.nodes[i - 1].depth)) {
      problems.push_back(name + " does not lie deeper than the one before it");
    }
  }
  if (!problems.empty()) return;
  for (const auto& segments : {blendedSegments(spec), blendedTorque(spec)}) {
    const bool isCurve = models::HermiteCurve<double>::isSound(segments.data(), segments.size());
    if (isCurve || segments.empty()) continue;
    problems.push_back("the material's nodes lie too close together, or too far apart, to be felt");
    return;
  }
}

void check(const PackingSpec& spec, Problems& problems) {
  checkScale(spec.hardness, spec.forceScale, problems);
  if (spec.bone == nullptr || spec.bone->packing.spheres.empty()) {
    problems.push_back("the bone has no spheres");
    return;
  }
  if (const auto problem = reaming::problemOf(*spec.bone); !problem.empty()) {
    problems.push_back(problem);
  }
  const std::size_t spheres = spec.bone->packing.spheres.size();
  for (const auto* densities : {&spec.bone->minimum, &spec.bone->average, &spec.bone->maximum}) {
    if (densities->size() == spheres) continue;
    problems.push_back("the bone's spheres have no densities: fit it with 'palpate packing fit'");
    return;
  }
}

}  // namespace

models::FiniteElements<double>::Parameters FiniteElementsSpec::asParameters() const noexcept {
  auto p = parameters;
  p.elementStiffnesses = elementStiffnesses.empty() ? nullptr : elementStiffnesses.data();
  return p;
}

const ModelInfo& infoOf(const ModelSpec& model) noexcept {
  return std::visit(
      [](const auto& spec) -> const ModelInfo& { return std::decay_t<decltype(spec)>::kInfo; },
      model);
}

ModelParts partsOf(const ModelSpec& model) noexcept {
  struct Parts {
    ModelParts operator()(const InterpolationSpec& spec) const { return {.cut = &spec}; }
    ModelParts operator()(const FiniteElementsSpec& spec) const { return {.elements = &spec}; }
    ModelParts operator()(const KalmanSpec& spec) const {
      return {.cut = &spec.interpolation, .elements = &spec.finiteElements, .filter = &spec};
    }
    ModelParts operator()(const MaterialSpec& spec) const { return {.material = &spec}; }
    ModelParts operator()(const PackingSpec& spec) const { return {.packing = &spec}; }
  };
  return std::visit(Parts{}, model);
}

FiniteElementsSpec elementsMatching(const InterpolationSpec& cut) {
  const auto& curve = cut.curve;
  double largest = 0.0;
  for (const auto& node : curve) largest = std::max(largest, node.force);
  FiniteElementsSpec spec;
  if (!(largest > 0.0)) return spec;
  // Yield: the first local maximum of at least half the largest force.
  std::size_t yield = 0;
  while (yield + 1 < curve.size() &&
         (curve[yield].force < 0.5 * largest || curve[yield + 1].force >= curve[yield].force)) {
    ++yield;
  }
  // Contact: the last point before the yield with at most 1 % of the largest force.
  std::size_t contact = yield;
  while (contact > 0 && curve[contact].force > 0.01 * largest) --contact;
  const double way = curve[yield].travel - curve[contact].travel;
  if (!(way > 0.0)) return spec;
  auto& p = spec.parameters;
  p.contact = curve[contact].travel;
  p.yieldForce = curve[yield].force;
  const double own = models::FiniteElements<double>(p).stiffness();
  p.elementStiffness *= (curve[yield].force - curve[contact].force) / way / own;
  return spec;
}

std::optional<double> endOfData(const ModelSpec& model) {
  const auto parts = partsOf(model);
  if (parts.cut != nullptr && !parts.cut->curve.empty()) {
    const auto& options = parts.cut->options;
    if (options.extrapolation == models::Extrapolation::Absent)
      return std::nullopt;  // the force of the finite elements continues
    const bool isRamp = options.extrapolation == models::Extrapolation::RampOut;
    const auto& last = parts.cut->curve.back();
    return last.travel + (isRamp && last.force != 0.0 ? options.rampLength : 0.0);
  }
  if (parts.material == nullptr) return std::nullopt;
  if (!parts.material->curves.isEmpty()) return parts.material->curves.end();
  if (parts.material->nodes.empty()) return std::nullopt;
  return parts.material->nodes.back().depth;
}

std::vector<ForceJump> jumpsOf(const ModelSpec& model) {
  using Curve = models::Interpolation<double>;
  constexpr double kLeastJump = 0.05;  // [N]
  const auto parts = partsOf(model);
  if (parts.material != nullptr && !parts.material->isRemoved) {
    const auto first = blendedSegments(*parts.material).front();
    if (std::abs(first.force) <= kLeastJump) return {};
    return {{.travel = first.begin, .from = 0.0, .to = first.force}};
  }
  const auto* cut = parts.cut;
  // Absent: beyond its ends the recording has no weight in the filter, which changes gradually.
  if (cut == nullptr || cut->options.extrapolation == models::Extrapolation::Absent) return {};
  std::vector<ForceJump> jumps;
  for (const auto* nodes : {&cut->curve, &cut->opening}) {
    if (nodes->empty() || (nodes == &cut->opening && cut->branches == Branches::ClosingOnly)) {
      continue;
    }
    const Curve curve(nodes->data(), nodes->size(), cut->options);
    const auto forceAt = [&](double travel) {
      std::size_t hint = 0;
      return curve.at(travel, hint).force;
    };
    const double first = nodes->front().travel;
    const double last = nodes->back().travel;
    // Far above the rounding of travel, and far shorter than any ramp.
    const double margin = 1e-9 * (last - first);
    for (const ForceJump jump :
         {ForceJump{first, forceAt(first - margin), forceAt(first)},
          ForceJump{last, forceAt(last), forceAt(last + margin)}}) {
      if (std::abs(jump.to - jump.from) > kLeastJump) jumps.push_back(jump);
    }
  }
  return jumps;
}

std::optional<ModelSpec> withoutNoiseAndRemoval(const ModelSpec& model) {
  struct Converter {
    using Result = std::optional<ModelSpec>;
    Result operator()(const InterpolationSpec&) const { return std::nullopt; }
    Result operator()(const FiniteElementsSpec&) const { return std::nullopt; }
    Result operator()(const KalmanSpec&) const { return std::nullopt; }
    Result operator()(MaterialSpec spec) const {
      spec.jitter = {};
      spec.isRemoved = false;
      return spec;
    }
    Result operator()(PackingSpec spec) const {
      spec.isRemoved = false;
      return spec;
    }
  };
  return std::visit(Converter{}, model);
}

double couplingOf(const ModelSpec& model) {
  const auto parts = partsOf(model);
  if (parts.material != nullptr && parts.material->isRemoved) return MaterialSpec::kCoupling;
  if (parts.packing != nullptr && parts.packing->isRemoved) return parts.packing->options.coupling;
  return 0.0;
}

double largestFeedOf(const SceneSpec& spec) {
  const auto parts = partsOf(spec.model);
  const bool isRemoved = (parts.material != nullptr && parts.material->isRemoved) ||
                         (parts.packing != nullptr && parts.packing->isRemoved);
  return isRemoved ? spec.reamer.mostFeed() : std::numeric_limits<double>::infinity();
}

bool hasTorque(const SceneSpec& spec) {
  if (spec.reamer.torqueSign() == 0) return false;
  const auto parts = partsOf(spec.model);
  if (parts.packing != nullptr) return parts.packing->options.friction > 0.0;
  if (parts.material == nullptr) return false;
  const auto& nodes = parts.material->nodes;
  return !parts.material->torque.isEmpty() ||
         (parts.material->curves.isEmpty() &&
          std::ranges::any_of(nodes, [](const auto& n) { return n.upperTorque > 0.0; }));
}

std::vector<std::string> problemsOf(const SceneSpec& spec) {
  Problems problems;
  std::visit([&](const auto& model) { check(model, problems); }, spec.model);
  if (!spec.reamer.isSound()) {
    problems.push_back(
        "the reamer needs a speed of 0, or of 0.000001 to 100 turns a second either way, a tooth "
        "and a feed per tooth above 0");
  }
  return problems;
}

}  // namespace haptics::engine
