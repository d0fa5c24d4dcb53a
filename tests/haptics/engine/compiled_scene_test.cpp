#include "haptics/engine/compiled_scene.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "haptics/engine/bone_models.h"
#include "haptics/engine/built_in_models.h"
#include "haptics/reaming/material/spline.h"

namespace haptics::engine {
namespace compiled_scene_test {

bool isInUse(const CompiledScene& scene, const std::string& name) {
  for (const auto& pass : scene.passes()) {
    if (pass.name == name) return pass.isInUse;
  }
  ADD_FAILURE() << "no pass '" << name << "'";
  return false;
}

const InterpolationSpec kCut{.curve = {{3.8, 0.0}, {7.2, 4.4}, {10.3, 3.4}}};

MaterialSpec bone(double hardness) {
  return {.nodes = parametricMaterial(), .hardness = hardness};
}

TEST(CompiledScene, HoldsNoFiniteElementsForInterpolationAlone) {
  const CompiledScene scene({.model = kCut});
  EXPECT_TRUE(isInUse(scene, "interpolation of the recorded cut"));
  EXPECT_FALSE(isInUse(scene, "finite elements: force"));
  EXPECT_FALSE(isInUse(scene, "finite elements: mesh"));
  EXPECT_FALSE(isInUse(scene, "Kalman filter"));
}

TEST(CompiledScene, HasAMeshOnlyIfItIsVisualised) {
  EXPECT_EQ(CompiledScene({.model = kCut}).mesh(), nullptr);
  const CompiledScene seen({.model = kCut, .isVisualised = true});
  ASSERT_NE(seen.mesh(), nullptr);
  EXPECT_EQ(seen.mesh()->at(8.0, 3.0).size(), 7U);  // five midpoints and both ends
  EXPECT_EQ(seen.mesh()->at(8.0, 3.0).front().displacement, 0.0);
}

/// How far the tissue gives way at the tool, straight between the two points beside it.
double seenAtTheTool(const MeshView& mesh, double tool, double travel, double force) {
  const auto points = mesh.at(travel, force);
  std::size_t i = 1;
  while (points[i].position < tool) ++i;
  const auto& a = points[i - 1];
  const auto& b = points[i];
  const double share = (tool - a.position) / (b.position - a.position);
  return (1.0 - share) * a.displacement + share * b.displacement;
}

TEST(MeshView, StaysAtTheToolAsThePenetrationDoes) {
  // Eq. (9) to (11): cᵀ y_mesh = θ − θ_contact; contact 4, the tool at 1.5.
  for (const int elements : {1, 5, 10, 15}) {
    FiniteElementsSpec spec;
    spec.parameters.elements = elements;
    const MeshView mesh(spec);
    EXPECT_NEAR(seenAtTheTool(mesh, 1.5, 8.0, 3.76), 4.0, 1e-12) << elements;
    EXPECT_NEAR(seenAtTheTool(mesh, 1.5, 10.0, 7.0), 6.0, 1e-12) << "beyond its yield force";
    EXPECT_EQ(seenAtTheTool(mesh, 1.5, 3.9, 0.0), 0.0) << "before the contact";
  }
}

TEST(MeshView, FollowsTheForceOnRequest) {
  const MeshView mesh(FiniteElementsSpec{}, TissueDrawing::Force);
  EXPECT_NEAR(seenAtTheTool(mesh, 1.5, 8.0, 3.76), 3.76 / (12.0 / 7.0), 1e-12);  // 2.19
}

TEST(MeshView, OfARecordedCutBeginsAndIsStiffAsTheCut) {
  // No force up to 3.8, from where it rises slowly; 4.4 N at 7.2.
  const auto like = elementsMatching(publishedInterpolation());
  EXPECT_NEAR(like.parameters.contact, 3.9, 0.11);
  EXPECT_NEAR(like.parameters.yieldForce, 4.4, 0.01);
  const CompiledScene seen(
      {.model = publishedInterpolation(),
       .isVisualised = true,
       .tissueDrawing = TissueDrawing::Force});
  const double slope = 4.4 / (7.2 - like.parameters.contact);
  EXPECT_NEAR(seenAtTheTool(*seen.mesh(), 1.5, 7.2, 4.4), 4.4 / slope, 0.05);
  const CompiledScene follows({.model = publishedInterpolation(), .isVisualised = true});
  EXPECT_NEAR(seenAtTheTool(*follows.mesh(), 1.5, 10.0, 3.3), 10.0 - like.parameters.contact, 1e-9);
}

TEST(CompiledScene, GivesAReasonForEveryPass) {
  const CompiledScene scene({.model = KalmanSpec{.interpolation = kCut}});
  for (const auto& pass : scene.passes()) {
    EXPECT_FALSE(pass.why.empty()) << pass.name;
  }
}

TEST(CompiledScene, NamesTheReasonWhenItRefusesAnUnsoundSpec) {
  EXPECT_THROW(CompiledScene({.model = InterpolationSpec{}}), std::invalid_argument);
  EXPECT_THROW(CompiledScene({.model = bone(1.5)}), std::invalid_argument);
}

TEST(SceneSpec, HasTheEndOfItsData) {
  auto ramp = kCut;
  ramp.options.rampLength = 2.0;
  EXPECT_DOUBLE_EQ(endOfData(ramp).value(), 12.3);
  auto held = kCut;
  held.options.extrapolation = models::Extrapolation::Hold;
  EXPECT_DOUBLE_EQ(endOfData(held).value(), 10.3);
  EXPECT_DOUBLE_EQ(endOfData(KalmanSpec{.interpolation = ramp}).value(), 12.3);
  EXPECT_DOUBLE_EQ(endOfData(bone(0.5)).value(), parametricMaterial().back().depth);
  EXPECT_FALSE(endOfData(FiniteElementsSpec{}).has_value());
}

TEST(CompiledScene, ReportsItsSteepestSlope) {
  EXPECT_DOUBLE_EQ(CompiledScene({.model = FiniteElementsSpec{}}).largestStiffness(), 12.0 / 7.0);
  const InterpolationSpec steep{
      .curve = {{0.0, 0.0}, {1.0, 4.0}, {2.0, 3.0}}, .options = {.rampLength = 3.0}};
  EXPECT_DOUBLE_EQ(CompiledScene({.model = steep}).largestStiffness(), 4.0);
}

TEST(CompiledScene, CountsTheWayFromOneBranchToTheOtherAsSteep) {
  const InterpolationSpec spec{
      .curve = {{0.0, 0.0}, {2.0, 8.0}},
      .options = {.rampLength = 3.0},
      .branches = Branches::Hysteresis,
      .opening = {{0.0, 0.0}, {1.0, 2.0}, {2.0, 8.0}},
      .transitionWidth = 0.5};
  const CompiledScene scene(SceneSpec{.model = spec});
  // The steeper branch has 6; at a travel of 1 they are 2 apart, which is crossed in half a unit.
  EXPECT_DOUBLE_EQ(scene.largestStiffness(), 6.0 + 2.0 / 0.5);
}

TEST(MaterialModel, IsTheLowerCurveAtZeroAndTheUpperOneAtOne) {
  for (const double h : {0.0, 1.0}) {
    MaterialModel model(bone(h));
    for (const auto& node : parametricMaterial()) {
      const double expected = h == 0.0 ? node.lower : node.upper;
      EXPECT_NEAR(model.respond({.travel = node.depth}).force, expected, 1e-9) << node.depth;
    }
  }
}

TEST(MaterialModel, GrowsWithHardnessEverywhere) {
  for (double depth = 0.0; depth <= 0.021; depth += 0.0001) {
    double last = -1.0;
    for (const double h : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      MaterialModel model(bone(h));
      const double force = model.respond({.travel = depth}).force;
      EXPECT_GE(force, last - 1e-12) << "at " << depth << " m, hardness " << h;
      last = force;
    }
  }
}

TEST(MaterialModel, NeverOvershootsItsNodes) {
  MaterialModel model(bone(1.0));
  const auto nodes = parametricMaterial();
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const double low = std::min(nodes[i].upper, nodes[i + 1].upper);
    const double high = std::max(nodes[i].upper, nodes[i + 1].upper);
    for (int part = 0; part <= 50; ++part) {
      const double depth = nodes[i].depth + (nodes[i + 1].depth - nodes[i].depth) * part / 50.0;
      const double force = model.respond({.travel = depth}).force;
      EXPECT_GE(force, low - 1e-9);
      EXPECT_LE(force, high + 1e-9);
    }
  }
}

TEST(CompiledScene, NamesTheInterpretationOfThePaper) {
  FiniteElementsSpec elements;
  elements.parameters.boundary = models::BoundaryCondition::B;
  elements.parameters.weights = models::ToolInterpolation::AuthorsFirmware;
  elements.parameters.yielding = models::YieldLaw::ReturnMap;
  const KalmanSpec fused{
      .interpolation = {.curve = {{0.0, 0.0}, {10.0, 4.0}}},
      .finiteElements = elements,
      .scheme = models::KalmanScheme::Sequential,
      .isProcessAsPrinted = true,
      .smoothing = models::Smoothing::TwoPoint};
  std::string said;
  const CompiledScene scene(SceneSpec{.model = fused});
  for (const auto& pass : scene.passes()) said += pass.why + "\n";
  for (const auto* name :
       {"boundary B",
        "weights authors-firmware",
        "yielding return-map",
        "variant sequential",
        "process as-printed",
        "smoothing two-point"}) {
    EXPECT_NE(said.find(name), std::string::npos) << name << "\n" << said;
  }
}

TEST(MaterialModel, StiffestSlopeIsThatOfTheCurve) {
  MaterialModel model(bone(0.7));
  double steepest = 0.0;
  for (double depth = 0.0; depth < 0.02; depth += 1e-6) {
    steepest = std::max(steepest, std::abs(model.respond({.travel = depth}).stiffness));
  }
  EXPECT_NEAR(model.largestStiffness() / steepest, 1.0, 1e-4);
  EXPECT_GE(model.largestStiffness(), steepest * (1.0 - 1e-12));
}

TEST(MaterialModel, TakesTheForceScale) {
  auto scaled = bone(0.5);
  scaled.forceScale = 0.15;
  EXPECT_NEAR(
      MaterialModel(scaled).respond({.travel = 0.01}).force,
      0.15 * MaterialModel(bone(0.5)).respond({.travel = 0.01}).force,
      1e-12);
}

TEST(MonotoneSlopes, EqualThoseOfAnIndependentImplementation) {
  // Python: scipy.interpolate.PchipInterpolator([0,1,3,4],[0,2,3,7]).derivative()([0,1,3,4]),
  // worked by hand from Fritsch & Butland: w = (5, 4) at x = 1, (4, 5) at x = 3.
  const auto slopes = reaming::monotoneSlopes({0.0, 1.0, 3.0, 4.0}, {0.0, 2.0, 3.0, 7.0});
  EXPECT_NEAR(slopes[1], 9.0 / (5.0 / 2.0 + 4.0 / 0.5), 1e-14);
  EXPECT_NEAR(slopes[2], 9.0 / (4.0 / 0.5 + 5.0 / 4.0), 1e-14);
  EXPECT_NEAR(slopes[0], (4.0 * 2.0 - 0.5) / 3.0, 1e-14);
}

}  // namespace compiled_scene_test
}  // namespace haptics::engine
