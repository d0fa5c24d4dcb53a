#include "haptics/engine/packing_model.h"

#include <algorithm>
#include <cmath>

namespace haptics::engine {
namespace {

constexpr double kDeepest = 0.02;  // of a plunge [m]

reaming::BoneOptions optionsOf(const PackingSpec& spec) {
  auto options = spec.options;
  options.coverage = spec.bone->packing.coverage();
  options.cuttingDamping *= spec.forceScale;
  options.isGuided = true;  // the device has one axis
  return options;
}

}  // namespace

PackingModel::PackingModel(const PackingSpec& spec)
    : field_(spec.bone->packing, spec.bone->densities(spec.hardness, spec.forceScale)),
      plunge_(reaming::plungeInto(field_, spec.bone->reamerRadius)),
      coverage_(spec.bone->packing.coverage()) {
  constexpr int kSteps = 1000;
  const double step = kDeepest / kSteps;
  double before = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double force = forceAt(step * i);
    largestStiffness_ = std::max(largestStiffness_, std::abs(force - before) / step);
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

RemovalModel::RemovalModel(const PackingSpec& spec, bool isSeen)
    : bone_(
          spec.bone->packing,
          spec.bone->densities(spec.hardness, spec.forceScale),
          optionsOf(spec)),
      plunge_(reaming::plungeInto(bone_.field(), spec.bone->reamerRadius)),
      stiffness_(spec.options.coupling),
      view_(isSeen ? std::make_unique<BoneView>() : nullptr) {}

models::Response<double> RemovalModel::respond(const ToolState& tool) noexcept {
  const auto felt = bone_.step(plunge_.at(tool.travel), tool.dt);
  if (view_) tellTheEye();
  return {-felt.force.z, 0.0, felt.isDefined};
}

void RemovalModel::tellTheEye() noexcept {
  if (bone_.restorations() != restorations_) {
    restorations_ = bone_.restorations();
    view_->tell({SphereChange::kAllAnew, {}});
  }
  view_->tellUntold(bone_.untoldChanges());
  view_->tellDepth(bone_.tool().centre.z - plunge_.start);
  for (const auto slot : bone_.changed()) {
    const auto& group = bone_.field().group(slot);
    const std::size_t lane = slot % reaming::kLanes;
    view_->tell({slot, {group.x[lane], group.y[lane], group.z[lane], group.radius[lane]}});
  }
}

}  // namespace haptics::engine
