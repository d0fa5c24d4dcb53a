#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptics/engine/bone_models.h"
#include "haptics/engine/force_model.h"
#include "haptics/engine/scene_spec.h"

namespace haptics::engine {

/// The tissue as it is seen: how the finite-element mesh gives way under the tool. Its shape is
/// solved once; drawing it is a product per point, at the display's rate, never in the tick.
///
///     penetration: y_mesh = K⁻¹ c (θ − θ_contact) / (cᵀ K⁻¹ c), so that cᵀ y_mesh = θ − θ_contact:
///                  the tissue stays at the tool (eq. (9) to (11) of the punch paper);
///     force:       y_mesh = K⁻¹ c f, with f the force at the handle, of any rendering.
class MeshView {
 public:
  explicit MeshView(const FiniteElementsSpec& spec, SeenTissue law = SeenTissue::Penetration);

  struct Point {
    double position = 0.0;      ///< along the tissue [string units]
    double displacement = 0.0;  ///< [travel units]
  };

  /// The ends and all midpoints, with the handle at @p travel [travel units] and a force @p force
  /// at it [N]. Nothing gives way before the contact.
  std::vector<Point> at(double travel, double force) const;

 private:
  SeenTissue law_;
  double contact_;            ///< [travel units]
  std::vector<Point> shape_;  ///< under one newton, or one travel unit of penetration
};

/// One step of computing a scene's force: whether this scene needs it, and why.
struct Pass {
  std::string name;
  bool isIn = false;
  std::string why;
  std::size_t bytes = 0;  ///< of memory that the tick touches
};

/// A condition made ready to be felt: holds just what this condition needs.
///
/// Built before the hand is on the tool; respond() then computes and returns.
class CompiledScene {
 public:
  /// @throws std::invalid_argument  naming everything that problemsOf(spec) finds.
  explicit CompiledScene(const SceneSpec& spec);

  models::Response<double> respond(const ToolState& tool) noexcept { return model_->respond(tool); }
  /// Of the last answer, about the tool's axis, right-handed about the way of advancing [N·m].
  double torque() const noexcept { return model_->torque(); }
  bool hasTorque() const noexcept { return model_->hasTorque(); }
  void reset() noexcept { model_->reset(); }
  double largestStiffness() const noexcept { return model_->largestStiffness(); }
  /// K of eq. (25) where the model's equations bound it [N per travel unit]; renderedSlope() has it
  /// for every scene.
  std::optional<double> slopeBound() const noexcept { return model_->slopeBound(); }
  double delay() const noexcept { return model_->delay(); }  ///< [ticks]
  bool isReady() const noexcept { return model_->isReady(); }

  /// nullptr where the condition is felt without being seen.
  const MeshView* mesh() const noexcept { return mesh_ ? &*mesh_ : nullptr; }

  /// nullptr where no bone is removed, or it is not drawn.
  BoneView* bone() const noexcept { return bone_; }

  /// What is in, what was left out, and why.
  const std::vector<Pass>& passes() const noexcept { return passes_; }

 private:
  std::unique_ptr<ForceModel> model_;
  std::optional<MeshView> mesh_;
  BoneView* bone_ = nullptr;  ///< the model's
  std::vector<Pass> passes_;
};

}  // namespace haptics::engine
