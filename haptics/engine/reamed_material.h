#pragma once

#include <cstddef>

#include "haptics/engine/bone_models.h"
#include "haptics/engine/force_model.h"
#include "haptics/engine/scene_spec.h"

namespace haptics::engine {

/// Bone of a hardness through which the reamer goes no faster than its teeth can take, whatever the
/// device pushes: a constrained tool, as of a bone of spheres (reaming::Bone), on a curve.
///
/// The tool is at the depth z, the device at x. The spring between them pushes with K (x − z), and
/// with the curve F(z) and the cutting damping b
///
///     ż = min((K (x − z) − F(z)) / b, speed · teeth · feedPerTooth),   0 where that is below 0;
///
/// what is rendered is the spring's force. It never pulls: a device that goes back takes the tool
/// with it, and the bone that it leaves is whole again, so that every stroke meets the same curve.
class ReamedMaterialModel final : public ForceModel {
 public:
  static constexpr double kCoupling =
      MaterialSpec::kCoupling;                       ///< K, as of a bone of spheres [N/m]
  static constexpr double kCuttingDamping = 2000.0;  ///< b of the default reamer [N·s/m]

  /// @param spec  valid, like the reamer.
  ReamedMaterialModel(const MaterialSpec& spec, const Reamer& reamer);

  models::Response<double> respond(const ToolState& tool) noexcept override;
  void reset() noexcept override;
  double largestStiffness() const noexcept override { return kCoupling; }
  /// That of the curve at the tool's depth; a share of it where the tool is pushed less than bone
  /// resists.
  double torque() const noexcept override { return torque_; }
  bool hasTorque() const noexcept override { return material_.hasTorque(); }

  double depth() const noexcept { return depth_; }  ///< of the tool [m]
  std::size_t bytes() const noexcept { return material_.bytes(); }

 private:
  MaterialModel material_;
  JitterNoise jitter_;
  double surface_;  ///< where the curve begins [m]
  double mostFeed_;
  double damping_;
  double depth_;
  double torque_ = 0.0;  ///< [N·m]
};

}  // namespace haptics::engine
