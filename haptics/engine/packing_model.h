#pragma once

#include <atomic>
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
  /// A slot that is none: the bone is whole again, all spheres are as at the beginning.
  static constexpr std::uint32_t kAllAnew = 0xffffffffU;

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
  /// What changed since it was last asked: one reader on another thread, with a picture of its own
  /// of all spheres. What found no room is counted in lostChanges().
  SphereChanges& changes() noexcept { return *changes_; }
  std::uint64_t lostChanges() const noexcept {
    return changes_->lost() + untold_.load(std::memory_order_relaxed);
  }

 private:
  reaming::Bone bone_;
  reaming::Plunge plunge_;
  double stiffness_;
  std::unique_ptr<SphereChanges> changes_;
  std::atomic<std::uint64_t> untold_{0};
  std::uint64_t restorations_ = 0;  ///< of the bone, that the reader has been told of
};

}  // namespace haptics::engine
