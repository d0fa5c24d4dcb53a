#include "haptics/engine/bone_models.h"

#include <algorithm>
#include <cmath>

#include "haptics/reaming/material/piecewise.h"

namespace haptics::engine {
namespace {

/// The two measured curves at a hardness, with slopes that keep them from overshooting.
reaming::CurveNodes blendedNodes(const MaterialSpec& spec) {
  std::vector<double> depths;
  std::vector<double> lower;
  std::vector<double> upper;
  for (const auto& node : spec.nodes) {
    depths.push_back(node.depth);
    lower.push_back(node.lower);
    upper.push_back(node.upper);
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

}  // namespace

std::vector<models::CubicSegment<double>> blendedSegments(const MaterialSpec& spec) {
  auto nodes =
      spec.curves.isEmpty() ? blendedNodes(spec) : reaming::curveOf(spec.curves, spec.hardness);
  for (auto& node : nodes) {
    node.force *= spec.forceScale;
    node.slope *= spec.forceScale;
  }
  std::vector<models::CubicSegment<double>> segments;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    segments.push_back(models::CubicSegment<double>::between(nodes[i], nodes[i + 1]));
  }
  return segments;
}

MaterialModel::MaterialModel(const MaterialSpec& spec)
    : segments_(blendedSegments(spec)),
      table_(knotsOf(segments_)),
      curve_(segments_.data(), segments_.size(), table_.index()),
      jitter_(spec.jitter, spec.forceScale, spec.jitterSeed) {}

double MaterialModel::largestStiffness() const noexcept {
  // The slope of a cubic is a parabola: largest at an end of its interval or at its apex.
  double largest = 0.0;
  for (const auto& segment : segments_) {
    const double apex = segment.begin - segment.square / (3.0 * segment.cube);
    const bool isInside = apex > segment.begin && apex < segment.end;  // not where cube is 0
    for (const double x : {segment.begin, segment.end, isInside ? apex : segment.begin}) {
      largest = std::max(largest, std::abs(segment.at(x).stiffness));
    }
  }
  return largest;
}

namespace {

/// How deep a reamer goes until it is through the bone [m].
double depthOf(const reaming::SphereField& field, const reaming::Plunge& plunge) {
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
  options.cuttingDamping = spec.forceScale * reamer.dampingOf(options.cuttingDamping);
  options.mostFeed = reamer.mostFeed();
  options.isSpinning = reamer.speed > 0.0;
  options.isGuided = true;  // the device has one axis
  return options;
}

}  // namespace

PackingModel::PackingModel(const PackingSpec& spec)
    : field_(spec.bone->packing, spec.bone->densities(spec.hardness, spec.forceScale)),
      plunge_(reaming::plungeInto(field_, spec.bone->reamerRadius)),
      coverage_(spec.bone->packing.coverage()) {
  constexpr double kStep = 20e-6;  // [m]
  const double deepest = spec.mostTravel > 0.0 ? spec.mostTravel : depthOf(field_, plunge_);
  double before = 0.0;
  for (int i = 0; i * kStep <= deepest; ++i) {
    const double force = forceAt(kStep * i);
    largestStiffness_ = std::max(largestStiffness_, std::abs(force - before) / kStep);
    before = force;
  }
}

double PackingModel::forceAt(double depth) const noexcept {
  return -field_.touch(plunge_.at(depth), false).force.z / coverage_;
}

models::Response<double> PackingModel::respond(const ToolState& tool) noexcept {
  if (!std::isfinite(tool.travel)) return {};
  return {forceAt(tool.travel), 0.0, true};
}

RemovalModel::RemovalModel(const PackingSpec& spec, bool isSeen, const Reamer& reamer)
    : bone_(
          spec.bone->packing,
          spec.bone->densities(spec.hardness, spec.forceScale),
          optionsOf(spec, reamer)),
      plunge_(reaming::plungeInto(bone_.field(), spec.bone->reamerRadius)),
      stiffness_(spec.options.coupling),
      isForwards_(reamer.speed > 0.0),
      view_(isSeen ? std::make_unique<BoneView>() : nullptr) {}

models::Response<double> RemovalModel::respond(const ToolState& tool) noexcept {
  bone_.setSpinning(isForwards_ && tool.isReamerOn);
  const auto felt = bone_.step(plunge_.at(tool.travel), tool.dt);
  if (view_) updateView();
  return {-felt.force.z, 0.0, felt.isDefined};
}

void RemovalModel::updateView() noexcept {
  if (bone_.restorations() != restorations_) {
    restorations_ = bone_.restorations();
    view_->tell({SphereChange::kAllAnew, {}});
  }
  view_->setUnreported(bone_.untoldChanges());
  view_->setDepth(bone_.tool().centre.z - plunge_.start);
  for (const auto slot : bone_.changed()) {
    const auto& group = bone_.field().group(slot);
    const std::size_t lane = slot % reaming::kLanes;
    view_->tell({slot, {group.x[lane], group.y[lane], group.z[lane], group.radius[lane]}});
  }
}

}  // namespace haptics::engine
