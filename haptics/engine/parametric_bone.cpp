#include "haptics/engine/parametric_bone.h"

#include "haptics/engine/parametric_material.h"
#include "haptics/reaming/material/piecewise.h"
#include "haptics/reaming/packing/acetabulum.h"
#include "haptics/reaming/packing/packing_builder.h"

namespace haptics::engine {

reaming::HardnessCurves parametricCurves() {
  const auto curveAt = [](double share) {
    std::vector<double> depths;
    std::vector<double> forces;
    for (const auto& node : parametricMaterial()) {
      depths.push_back(node.depth);
      forces.push_back((1.0 - share) * node.lower + share * node.upper);
    }
    const auto slopes = reaming::monotoneSlopes(depths, forces);
    reaming::CurveNodes nodes;
    for (std::size_t i = 0; i < depths.size(); ++i) {
      nodes.push_back({depths[i], forces[i], slopes[i]});
    }
    return nodes;
  };
  return {curveAt(0.0), curveAt(0.5), curveAt(1.0)};
}

std::shared_ptr<const reaming::PackedBone> parametricBone() {
  static const auto bone = [] {
    constexpr std::size_t kSpheres = 20'000;
    auto made = std::make_shared<reaming::PackedBone>();
    made->name = "parametric";
    made->title = "A cup of our own making";
    made->isSynthetic = true;
    made->packing = *reaming::pack(reaming::Acetabulum(), {.count = kSpheres});
    reaming::fitTo(*made, parametricCurves());
    return made;
  }();
  return bone;
}

}  // namespace haptics::engine
