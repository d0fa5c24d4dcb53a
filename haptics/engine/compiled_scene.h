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

/// The drawn tissue: displacements of the finite-element mesh under the tool. The constructor
/// solves for the shape; at() only scales it. Used at the display's rate, never in the tick.
///
///     penetration: y_mesh = K⁻¹ c (θ − θ_contact) / (cᵀ K⁻¹ c), so that cᵀ y_mesh = θ − θ_contact:
///                  the tissue follows the tool (eq. (9) to (11) of the punch paper);
///     force: y_mesh = K⁻¹ c f, with f the rendered force at the handle.
class MeshView {
 public:
  explicit MeshView(
      const FiniteElementsSpec& spec, TissueDrawing drawing = TissueDrawing::Penetration);

  struct Point {
    double position = 0.0;      ///< along the tissue, in the unit of start and end of
                                ///< models::FiniteElements [string units]
    double displacement = 0.0;  ///< [travel units]
  };

  /// Both ends and the midpoint of every element, with the handle at @p travel [travel units] and
  /// the rendered @p force [N]. Displacements are 0 before contact.
  std::vector<Point> at(double travel, double force) const;

 private:
  TissueDrawing drawing_;
  double contact_;            ///< [travel units]
  std::vector<Point> shape_;  ///< for 1 N, or for 1 travel unit of penetration
};

/// One step of computing a scene's force: whether this scene needs it, and why.
struct Pass {
  std::string name;
  bool isInUse = false;
  std::string why;
  std::size_t bytes = 0;  ///< of memory that the tick reads
};

/// A scene that is ready to be rendered: the force model and the views that the condition needs.
///
/// Construction allocates and may take long; respond() is for the tick.
class CompiledScene {
 public:
  /// @throws std::invalid_argument  with all problems that problemsOf(spec) finds.
  explicit CompiledScene(const SceneSpec& spec);

  models::Response<double> respond(const ToolState& tool) noexcept { return model_->respond(tool); }
  /// Torque of the last response, about the tool's axis, right-handed about the direction of
  /// advance [N·m].
  double torque() const noexcept { return model_->torque(); }
  bool hasTorque() const noexcept { return model_->hasTorque(); }
  void reset() noexcept { model_->reset(); }
  double largestStiffness() const noexcept { return model_->largestStiffness(); }
  /// K of eq. (25), if the model knows it; renderedSlope() gives K for every scene.
  std::optional<SlopeBound> slopeBound() const noexcept { return model_->slopeBound(); }
  double delay() const noexcept { return model_->delay(); }  ///< [ticks]
  bool isReady() const noexcept { return model_->isReady(); }

  /// nullptr if no meniscus is drawn.
  const MeshView* mesh() const noexcept { return mesh_ ? &*mesh_ : nullptr; }

  /// nullptr if the scene removes no bone, or does not draw it.
  BoneView* bone() const noexcept { return bone_; }

  /// All passes: those in use and those left out, with the reasons.
  const std::vector<Pass>& passes() const noexcept { return passes_; }

 private:
  std::unique_ptr<ForceModel> model_;
  std::optional<MeshView> mesh_;
  BoneView* bone_ = nullptr;  ///< owned by model_
  std::vector<Pass> passes_;
};

}  // namespace haptics::engine
