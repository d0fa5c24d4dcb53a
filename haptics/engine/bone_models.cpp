#include "haptics/engine/bone_models.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "haptics/reaming/material/spline.h"

namespace haptics::engine {
namespace {

/// Nodes of the lower and the upper curve, blended for the hardness of @p spec, with slopes that
/// avoid overshoot between nodes.
reaming::CurveNodes blendedNodes(
    const MaterialSpec& spec, double MaterialNode::*low, double MaterialNode::*high) {
  std::vector<double> depths;
  std::vector<double> lower;
  std::vector<double> upper;
  for (const auto& node : spec.nodes) {
    depths.push_back(node.depth);
    lower.push_back(node.*low);
    upper.push_back(node.*high);
  }
  const auto lowerSlopes = reaming::monotoneSlopes(depths, lower);
  const auto upperSlopes = reaming::monotoneSlopes(depths, upper);
  const double h = spec.hardness;
  reaming::CurveNodes nodes;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    nodes.push_back(
        {depths[i],
         (1.0 - h) * lower[i] + h * upper[i],
         (1.0 - h) * lowerSlopes[i] + h * upperSlopes[i]});
  }
  return nodes;
}

std::vector<double> knotsOf(const std::vector<models::CubicSegment<double>>& segments) {
  std::vector<double> knots;
  for (const auto& segment : segments) knots.push_back(segment.begin);
  knots.push_back(segments.back().end);
  return knots;
}

std::vector<models::CubicSegment<double>> scaledSegments(reaming::CurveNodes nodes, double scale) {
  for (auto& node : nodes) {
    node.force *= scale;
    node.slope *= scale;
  }
  std::vector<models::CubicSegment<double>> segments;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    segments.push_back(models::CubicSegment<double>::between(nodes[i], nodes[i + 1]));
  }
  return segments;
}

}  // namespace

std::vector<models::CubicSegment<double>> blendedSegments(const MaterialSpec& spec) {
  auto nodes = spec.curves.isEmpty()
                   ? blendedNodes(spec, &MaterialNode::lower, &MaterialNode::upper)
                   : reaming::curveOf(spec.curves, spec.hardness);
  return scaledSegments(std::move(nodes), spec.forceScale);
}

std::vector<models::CubicSegment<double>> blendedTorque(const MaterialSpec& spec) {
  if (!spec.torque.isEmpty()) {
    return scaledSegments(reaming::curveOf(spec.torque, spec.hardness), spec.forceScale);
  }
  if (!spec.curves.isEmpty()) return {};
  const auto nodes = blendedNodes(spec, &MaterialNode::lowerTorque, &MaterialNode::upperTorque);
  const bool isAny = std::ranges::any_of(nodes, [](const auto& node) { return node.force > 0.0; });
  if (!isAny) return {};
  return scaledSegments(nodes, spec.forceScale);
}

BlendedCurve::BlendedCurve(Segments segments)
    : segments_(std::move(segments)),
      table_(knotsOf(segments_)),
      curve_(segments_.data(), segments_.size(), table_.index()) {}

MaterialModel::MaterialModel(const MaterialSpec& spec, const Reamer& reamer)
    : force_(blendedSegments(spec)),
      sign_(reamer.torqueSign()),
      jitter_(spec.jitter, spec.forceScale, spec.jitterSeed) {
  if (sign_ == 0) return;
  if (auto torque = blendedTorque(spec); !torque.empty()) torqueCurve_.emplace(std::move(torque));
}

void MaterialModel::updateTorque(const ToolState& tool) noexcept {
  torque_ = 0.0;
  if (!torqueCurve_ || !tool.isReamerOn) return;
  const auto response = torqueCurve_->at(tool.travel);
  // Friction never drives: a spline that dips below 0 near first contact counts as 0.
  torque_ = response.isDefined ? sign_ * std::max(0.0, response.force) : 0.0;
}

double MaterialModel::largestStiffness() const noexcept {
  // The slope of a cubic is a parabola: largest at an end of its interval or at its apex.
  double largest = 0.0;
  for (const auto& segment : force_.segments()) {
    const double apex = segment.begin - segment.square / (3.0 * segment.cube);
    const bool isInside = apex > segment.begin && apex < segment.end;  // false if cube is 0
    for (const double x : {segment.begin, segment.end, isInside ? apex : segment.begin}) {
      largest = std::max(largest, std::abs(segment.at(x).stiffness));
    }
  }
  return largest;
}

std::optional<SlopeBound> MaterialModel::slopeBound() const noexcept {
  // Before its first node the curve has no force.
  if (force_.segments().front().force != 0.0) return std::nullopt;
  return ForceModel::slopeBound();
}

namespace {

/// The depth at which a reamer leaves the bone on the far side [m].
double exitDepthOf(const reaming::SphereField& field, const reaming::PlungePath& plunge) {
  double last = plunge.start;
  for (std::size_t slot = 0; slot < field.slotCount(); ++slot) {
    const double radius = field.group(slot).radius[slot % reaming::kLanes];
    if (radius > 0.0) last = std::max(last, field.centre(slot).z + radius);
  }
  return last + plunge.radius - plunge.start;
}

reaming::BoneOptions optionsOf(const PackingSpec& spec, const Reamer& reamer) {
  auto options = spec.options;
  options.coverage = spec.bone->packing.coverage();
  options.cuttingDamping = spec.forceScale * reamer.cuttingDampingOf(options.cuttingDamping);
  options.mostFeed = reamer.mostFeed();
  options.isSpinning = reamer.speed > 0.0;
  options.isGuided = true;  // the device has one axis
  return options;
}

}  // namespace

PackingModel::PackingModel(const PackingSpec& spec, const Reamer& reamer)
    : field_(spec.bone->packing, spec.bone->densities(spec.hardness, spec.forceScale)),
      plunge_(reaming::plungePathInto(field_, spec.bone->reamerRadius)),
      coverage_(spec.bone->packing.coverage()),
      friction_(reamer.torqueSign() * spec.options.friction) {
  constexpr double kStep = 20e-6;  // [m]
  const double deepest =
      exitDepthOf(field_, plunge_);  // a device may reach beyond its kind's travel
  double before = 0.0;
  for (int i = 0; i * kStep <= deepest; ++i) {
    const double force = forceOf(field_.touch(plunge_.at(kStep * i), false));
    largestStiffness_ = std::max(largestStiffness_, std::abs(force - before) / kStep);
    before = force;
  }
}

models::Response<double> PackingModel::respond(const ToolState& tool) noexcept {
  torque_ = 0.0;
  if (!std::isfinite(tool.travel)) return {};
  const auto contact = field_.touch(plunge_.at(tool.travel), false);
  // Friction of each contact patch acts at its distance from the axis (the lever).
  torque_ = tool.isReamerOn ? friction_ * contact.lever / coverage_ : 0.0;
  return {forceOf(contact), 0.0, true};
}

RemovalModel::RemovalModel(const PackingSpec& spec, bool isVisualised, const Reamer& reamer)
    : bone_(
          spec.bone->packing,
          spec.bone->densities(spec.hardness, spec.forceScale),
          optionsOf(spec, reamer)),
      plunge_(reaming::plungePathInto(bone_.field(), spec.bone->reamerRadius)),
      stiffness_(spec.options.coupling),
      isTurningForwards_(reamer.speed > 0.0),
      torqueSign_(spec.options.friction > 0.0 ? reamer.torqueSign() : 0),
      view_(isVisualised ? std::make_unique<BoneView>() : nullptr) {}

models::Response<double> RemovalModel::respond(const ToolState& tool) noexcept {
  bone_.setSpinning(isTurningForwards_ && tool.isReamerOn);
  const auto felt = bone_.step(plunge_.at(tool.travel), tool.dt);
  if (view_) updateView();
  torque_ = tool.isReamerOn ? torqueSign_ * felt.frictionTorque : 0.0;
  return {-felt.force.z, 0.0, felt.isDefined};
}

void RemovalModel::updateView() noexcept {
  if (bone_.restorations() != restorations_) {
    restorations_ = bone_.restorations();
    view_->add({SphereChange::kWholeBoneReset, {}});
  }
  view_->setUnreported(bone_.droppedChanges());
  view_->setDepth(bone_.tool().centre.z - plunge_.start);
  for (const auto slot : bone_.changed()) {
    const auto& group = bone_.field().group(slot);
    const std::size_t lane = slot % reaming::kLanes;
    view_->add({slot, {group.x[lane], group.y[lane], group.z[lane], group.radius[lane]}});
  }
}

}  // namespace haptics::engine
