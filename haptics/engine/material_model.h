#pragma once

#include <vector>

#include "haptics/engine/bucket_table.h"
#include "haptics/engine/force_model.h"
#include "haptics/engine/scene_spec.h"
#include "haptics/models/hermite_curve.h"

namespace haptics::engine {

/// Bone of a hardness: the two measured curves are blended once, when it is built, so that the tick
/// evaluates a single cubic.
class MaterialModel final : public ForceModel {
 public:
  /// @param spec  sound.
  explicit MaterialModel(const MaterialSpec& spec);

  models::Response<double> respond(const ToolState& tool) noexcept override {
    return curve_.at(tool.travel, hint_);
  }
  void reset() noexcept override { hint_ = 0; }
  double largestStiffness() const noexcept override;

  const std::vector<models::CubicSegment<double>>& segments() const noexcept { return segments_; }

 private:
  std::vector<models::CubicSegment<double>> segments_;
  BucketTable table_;
  models::HermiteCurve<double> curve_;
  std::size_t hint_ = 0;
};

/// Both measured curves at the material's hardness, scaled: the segments of a material whose nodes
/// are in order.
std::vector<models::CubicSegment<double>> blendedSegments(const MaterialSpec& spec);

/// Slopes at the nodes of a curve that keep its cubic Hermite spline from overshooting: weighted
/// harmonic means inside, one-sided at the ends (Fritsch & Butland 1984, "PCHIP").
std::vector<double> monotoneSlopes(
    const std::vector<double>& positions, const std::vector<double>& values);

}  // namespace haptics::engine
