#pragma once

#include <cstddef>

#include "haptics/engine/bone_models.h"
#include "haptics/engine/force_model.h"
#include "haptics/engine/scene_spec.h"

namespace haptics::engine {

/// Force of bone through which the reamer advances no faster than its teeth can cut, however hard
/// the device pushes: a constrained tool like that of reaming::Bone, on a force curve.
///
/// The tool is at depth z, the device at x. The spring between them pushes with K (x − z). With the
/// force curve F(z) and the cutting damping b,
///
///     ż = min((K (x − z) − F(z)) / b, speed · teeth · feedPerTooth),   0 where that is below 0;
///
/// The rendered force is the spring's. It never pulls: a device that moves back takes the tool
/// along, and the bone there is whole again, so that every stroke meets the same curve.
class ReamedMaterialModel final : public ForceModel {
 public:
  /// K, the same as for a bone of spheres [N/m]
  static constexpr double kCoupling = MaterialSpec::kCoupling;
  static constexpr double kCuttingDamping = 2000.0;  ///< b for the default reamer [N·s/m]

  /// @param spec  and @p reamer: valid, see problemsOf().
  ReamedMaterialModel(const MaterialSpec& spec, const Reamer& reamer);

  models::Response<double> respond(const ToolState& tool) noexcept override;
  void reset() noexcept override;
  double largestStiffness() const noexcept override { return kCoupling; }
  /// The torque curve at the tool's depth; proportionally less if the push is smaller than the
  /// resistance of the bone.
  double torque() const noexcept override { return torque_; }
  bool hasTorque() const noexcept override { return material_.hasTorque(); }

  double depth() const noexcept { return depth_; }  ///< depth of the tool [m]
  /// Memory of the force curve [bytes].
  std::size_t bytes() const noexcept { return material_.bytes(); }

 private:
  MaterialModel material_;
  JitterNoise jitter_;
  double surfaceDepth_;  ///< depth at which the force curve begins [m]
  double mostFeed_;
  double damping_;
  double depth_;
  double torque_ = 0.0;  ///< [N·m]
};

}  // namespace haptics::engine
