#include "haptics/engine/built_in_models.h"

#include "haptics/reaming/material/spline.h"
#include "haptics/reaming/packing/packing_builder.h"
#include "haptics/reaming/packing/solids.h"
#include "haptics/recordings/cut.h"

namespace haptics::engine {

namespace {

/// Ratio of torque to force of the parametric material and of the synthetic series [m]: friction at
/// about the reamer's radius, since the curves of force and torque "look similar" (reaming paper,
/// Fig. 5).
constexpr double kParametricLever = 0.028;

}  // namespace

InterpolationSpec publishedInterpolation() {
  InterpolationSpec spec;
  const auto cut = recordings::parametricCut();
  for (const auto& node : cut.curve.nodes()) spec.curve.push_back({node.travel, node.force});
  return spec;
}

FiniteElementsSpec publishedElements(int elements) {
  FiniteElementsSpec spec;
  spec.parameters.elements = elements;
  return spec;
}

KalmanSpec publishedFilter(models::KalmanScheme scheme, int elements) {
  return {
      .interpolation = publishedInterpolation(),
      .finiteElements = publishedElements(elements),
      .noise = models::KalmanNoise<double>::published(models::ProcessNoiseReading::StateOrder),
      .scheme = scheme};
}

std::vector<MaterialNode> parametricMaterial() {
  std::vector<MaterialNode> nodes{
      {0.000, 0.0, 0.0},
      {0.001, 0.5, 4.0},
      {0.002, 2.0, 20.0},
      {0.003, 8.0, 90.0},
      {0.004, 20.0, 230.0},
      {0.005, 30.0, 330.0},  // the local peak: the subchondral lamella
      {0.006, 27.0, 300.0},
      {0.007, 24.0, 285.0},
      {0.009, 28.0, 360.0},
      {0.012, 38.0, 500.0},
      {0.016, 50.0, 660.0},
      {0.020, 60.0, 800.0},
  };
  for (auto& node : nodes) {
    node.lowerTorque = kParametricLever * node.lower;
    node.upperTorque = kParametricLever * node.upper;
  }
  return nodes;
}

namespace {

/// The lower, halfway and upper curve between two values of the parametric material's nodes.
reaming::HardnessCurves curvesBetween(double MaterialNode::*lower, double MaterialNode::*upper) {
  const auto curveAt = [&](double share) {
    std::vector<double> depths;
    std::vector<double> forces;
    for (const auto& node : parametricMaterial()) {
      depths.push_back(node.depth);
      forces.push_back((1.0 - share) * node.*lower + share * node.*upper);
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

}  // namespace

reaming::HardnessCurves parametricCurves() {
  return curvesBetween(&MaterialNode::lower, &MaterialNode::upper);
}

reaming::HardnessCurves parametricTorque() {
  return curvesBetween(&MaterialNode::lowerTorque, &MaterialNode::upperTorque);
}

std::shared_ptr<const reaming::PackedBone> parametricBone() {
  static const auto bone = [] {
    constexpr std::size_t kSpheres = 20'000;
    auto made = std::make_shared<reaming::PackedBone>();
    made->name = "parametric";
    made->title = "A cup of our own making";
    made->isSynthetic = true;
    made->packing = *reaming::pack(reaming::Acetabulum(), {.count = kSpheres});
    // `packing fit` needs seconds to find this friction, and 400 depths hardly improve the fit.
    // With this friction and 150 depths the error at any depth is 0.08 % of the force and 1.4 %
    // of the torque.
    reaming::fitBoneToMaterial(
        *made, parametricCurves(), parametricTorque(), {.depths = 150, .friction = 0.2});
    return made;
  }();
  return bone;
}

}  // namespace haptics::engine
