#pragma once

#include <memory>
#include <optional>

#include "haptics/engine/force_model.h"
#include "haptics/engine/sample_ring.h"
#include "haptics/engine/scene_spec.h"
#include "haptics/reaming/bone.h"
#include "haptics/reaming/packed_bone.h"
#include "haptics/reaming/plunge.h"

namespace haptics::engine {

/// A sphere that has changed, for whoever draws the bone. A radius of 0: it is gone.
struct SphereChange {
  std::uint32_t slot = 0;
  reaming::Sphere sphere;
};
using SphereChanges = SampleRing<SphereChange, 1U << 15U>;

/// A bone of spheres that stays as it is: a force for every depth of the plunge.
class PackingModel final : public ForceModel {
 public:
  /// @param spec  sound.
  explicit PackingModel(const PackingSpec& spec);

  models::Response<double> respond(const ToolState& tool) noexcept override;
  void reset() noexcept override {}
  double largestStiffness() const noexcept override { return largestStiffness_; }
  std::size_t bytes() const noexcept { return field_.bytes(); }

 private:
  double forceAt(double depth) const noexcept;

  reaming::SphereField field_;
  reaming::Plunge plunge_;
  double coverage_;
  double largestStiffness_ = 0.0;
};

/// A bone of spheres from which the reamer takes what it goes through.
class RemovalModel final : public ForceModel {
 public:
  /// @param spec  sound.
  explicit RemovalModel(const PackingSpec& spec);

  models::Response<double> respond(const ToolState& tool) noexcept override;
  void reset() noexcept override { bone_.reset(); }
  double largestStiffness() const noexcept override { return stiffness_; }
  std::size_t bytes() const noexcept { return bone_.field().bytes(); }

  const reaming::Bone& bone() const noexcept { return bone_; }
  /// What changed since it was last asked: one reader on another thread. Changes for which there
  /// was no room are counted as lost; then all spheres are to be looked at.
  SphereChanges& changes() noexcept { return *changes_; }

 private:
  reaming::Bone bone_;
  reaming::Plunge plunge_;
  double stiffness_;
  std::unique_ptr<SphereChanges> changes_;
};

}  // namespace haptics::engine
