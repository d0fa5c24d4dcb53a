#include "haptics/engine/reamed_material.h"

#include <algorithm>
#include <cmath>

namespace haptics::engine {
namespace {

MaterialSpec withoutJitter(MaterialSpec spec) {
  spec.jitter = {};
  return spec;
}

}  // namespace

ReamedMaterialModel::ReamedMaterialModel(const MaterialSpec& spec, const Reamer& reamer)
    : material_(withoutJitter(spec), reamer),
      jitter_(spec.jitter, spec.forceScale, spec.jitterSeed),
      surfaceDepth_(material_.segments().front().begin),
      mostFeed_(reamer.mostFeed()),
      damping_(spec.forceScale * reamer.cuttingDampingOf(kCuttingDamping)),
      depth_(surfaceDepth_) {}

models::Response<double> ReamedMaterialModel::respond(const ToolState& tool) noexcept {
  torque_ = 0.0;
  if (!std::isfinite(tool.travel)) return {};
  if (tool.travel <= depth_) {
    depth_ = std::max(tool.travel, surfaceDepth_);
    return {0.0, 0.0, true};
  }
  const double mostFeed = tool.isReamerOn ? mostFeed_ : 0.0;
  const double resistance =
      std::max(0.0, material_.respond({.travel = depth_, .isReamerOn = tool.isReamerOn}).force);
  const double push = kCoupling * (tool.travel - depth_);
  torque_ = material_.torque() * (push < resistance ? push / resistance : 1.0);
  if (push > resistance) {
    // Implicit integration, stable for every dt, as in reaming::Bone.
    const double advance = (push - resistance) / (kCoupling + damping_ / tool.dt);
    depth_ += std::min(advance, mostFeed * tool.dt);
  }
  const double force = kCoupling * (tool.travel - depth_);
  // The spinning reamer caused the jitter of the measurement: without feed there is none.
  const double noise = mostFeed > 0.0 ? jitter_.step(force, tool.dt) : 0.0;
  return {force + noise, kCoupling, true};
}

void ReamedMaterialModel::reset() noexcept {
  depth_ = surfaceDepth_;
  torque_ = 0.0;
  jitter_.reset();
}

}  // namespace haptics::engine
