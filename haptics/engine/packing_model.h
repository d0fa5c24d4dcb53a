#pragma once

#include <memory>
#include <optional>

#include "haptics/engine/bone_view.h"
#include "haptics/engine/force_model.h"
#include "haptics/engine/scene_spec.h"
#include "haptics/reaming/bone/bone.h"
#include "haptics/reaming/bone/plunge.h"
#include "haptics/reaming/packing/packed_bone.h"

namespace haptics::engine {

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
  /// @param spec  sound. @param isSeen  somebody draws it: only then is there a view of it.
  explicit RemovalModel(const PackingSpec& spec, bool isSeen = false);

  models::Response<double> respond(const ToolState& tool) noexcept override;
  void reset() noexcept override { bone_.reset(); }
  double largestStiffness() const noexcept override { return stiffness_; }
  std::size_t bytes() const noexcept { return bone_.field().bytes(); }

  const reaming::Bone& bone() const noexcept { return bone_; }
  /// Nothing where nobody draws it.
  BoneView* view() const noexcept { return view_.get(); }

 private:
  void tellTheEye() noexcept;

  reaming::Bone bone_;
  reaming::Plunge plunge_;
  double stiffness_;
  std::unique_ptr<BoneView> view_;
  std::uint64_t restorations_ = 0;  ///< of the bone, that the reader has been told of
};

}  // namespace haptics::engine
