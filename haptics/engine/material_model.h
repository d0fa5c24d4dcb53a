#pragma once

#include <vector>

#include "haptics/engine/bucket_table.h"
#include "haptics/engine/force_model.h"
#include "haptics/engine/jitter_noise.h"
#include "haptics/engine/scene_spec.h"
#include "haptics/models/hermite_curve.h"

namespace haptics::engine {

/// Bone of a hardness: the curves are blended once, when it is built, so that the tick
/// evaluates a single cubic.
class MaterialModel final : public ForceModel {
 public:
  /// @param spec  sound.
  explicit MaterialModel(const MaterialSpec& spec);

  models::Response<double> respond(const ToolState& tool) noexcept override {
    auto response = curve_.at(tool.travel, hint_);
    if (response.isDefined) response.force += jitter_.step(response.force, tool.dt);
    return response;
  }
  void reset() noexcept override {
    hint_ = 0;
    jitter_.reset();
  }
  double largestStiffness() const noexcept override;

  const std::vector<models::CubicSegment<double>>& segments() const noexcept { return segments_; }

 private:
  std::vector<models::CubicSegment<double>> segments_;
  BucketTable table_;
  models::HermiteCurve<double> curve_;
  std::size_t hint_ = 0;
  JitterNoise jitter_;
};

/// Both measured curves at the material's hardness, scaled: the segments of a material whose nodes
/// are in order.
std::vector<models::CubicSegment<double>> blendedSegments(const MaterialSpec& spec);

}  // namespace haptics::engine
