#include <cmath>

#include <gtest/gtest.h>

#include "haptics/devices/hand.h"
#include "haptics/devices/iiwa/reamer_kind.h"
#include "haptics/devices/simulated_device.h"
#include "haptics/engine/bone_models.h"
#include "haptics/engine/built_in_models.h"
#include "haptics/engine/compiled_scene.h"
#include "haptics/engine/force_engine.h"

namespace haptics::engine {
namespace packing_model_test {

PackingSpec spec(bool isRemoved) {
  return {.bone = parametricBone(), .hardness = 0.5, .forceScale = 0.15, .isRemoved = isRemoved};
}

TEST(PackingModel, HasTheForceOfItsMaterialWithoutRemoval) {
  PackingModel model(spec(false));
  const auto curve = reaming::curveOf(parametricCurves(), 0.5);
  for (int round = 0; round < 2; ++round) {
    for (double depth = 0.0; depth < 0.019; depth += 0.0005) {
      const auto felt = model.respond({.travel = depth});
      ASSERT_TRUE(felt.isDefined);
      ASSERT_NEAR(felt.force, 0.15 * reaming::forceOf(curve, depth), 1.0) << depth;
    }
  }
  EXPECT_GT(model.largestStiffness(), 1000.0);
  EXPECT_FALSE(model.respond({.travel = std::nan("")}).isDefined);
}

TEST(RemovalModel, RendersTheMaterialOnceAndReportsRemovedSpheresToTheView) {
  RemovalModel model(spec(true), true);
  const auto curve = reaming::curveOf(parametricCurves(), 0.5);
  while (!model.respond({.travel = 0.0}).isDefined) {
  }
  double worst = 0.0;
  double travel = 0.0;
  for (; travel < 0.012; travel += 1e-6) {
    const auto felt = model.respond({.travel = travel});
    const double tool = travel - felt.force / model.largestStiffness();
    worst = std::max(worst, std::abs(felt.force - 0.15 * reaming::forceOf(curve, tool)));
  }
  EXPECT_LT(worst, 4.0);  // of up to 40 N, of which 2 N are the damping of a feed of 1 mm/s
  SphereChange change;
  int gone = 0;
  while (model.view()->next(change)) gone += change.sphere.radius == 0.0F ? 1 : 0;
  EXPECT_GT(gone, 100);
  EXPECT_EQ(model.view()->lost(), 0U);
  for (; travel > 0.0; travel -= 1e-5) model.respond({.travel = travel});
  EXPECT_LT(model.respond({.travel = 0.006}).force, 0.5);
  model.reset();
  for (int i = 0; i < 50; ++i) model.respond({.travel = -0.001});
  bool isToldAnew = false;
  while (model.view()->next(change)) isToldAnew |= change.slot == SphereChange::kWholeBoneReset;
  EXPECT_TRUE(isToldAnew);
}

TEST(CompiledScene, ReportsChangesOfABoneOnlyIfItIsVisualised) {
  SceneSpec scene{.model = spec(true)};
  EXPECT_EQ(CompiledScene(scene).bone(), nullptr);
  scene.isVisualised = true;
  EXPECT_NE(CompiledScene(scene).bone(), nullptr);
  scene.model = spec(false);
  EXPECT_EQ(CompiledScene(scene).bone(), nullptr);  // nothing in it changes
}

TEST(RemovalModel, ReportsTheDepthOfTheReamerToTheView) {
  RemovalModel model(spec(true), true);
  while (!model.respond({.travel = -0.001}).isDefined) {
  }
  model.respond({.travel = -0.001});
  EXPECT_NEAR(model.view()->depth(), -0.001, 1e-4);
  for (int i = 0; i < 50; ++i) model.respond({.travel = 0.01});
  EXPECT_LT(model.view()->depth(), 0.009);  // the hand is ahead of it
}

TEST(RemovalModel, IsReamedByAHand) {
  devices::SimulatedHand::Person person{
      .open = 0.0, .closed = 0.02, .stiffness = 4000.0, .damping = 200.0};
  devices::SimulatedHand hand(person);
  auto capabilities = devices::simulated(devices::reamerKind());
  devices::SimulatedDevice device(capabilities, devices::reamerKind().mechanism, hand);
  ForceEngine engine(device, {.maxForce = 140.0, .maxRate = 5000.0, .maxVelocity = 1.0});
  CompiledScene scene({.model = spec(true)});
  engine.setScene(&scene);
  engine.arm();
  double deepest[3] = {};
  double hardest = 0.0;
  for (int i = 0; i < 6000; ++i) {
    const auto sample = engine.tick(0.001);
    ASSERT_TRUE(std::isfinite(sample.force));
    deepest[i / 2000] = std::max(deepest[i / 2000], sample.travel);
    hardest = std::max(hardest, sample.force);
  }
  EXPECT_GT(hardest, 5.0);
  EXPECT_GT(deepest[2], deepest[0]);  // every stroke gets further
}

TEST(CompiledScene, KeepsOnlyThePartsOfABoneThatItNeeds) {
  const auto partsOf = [](const SceneSpec& scene) {
    std::string in;
    const CompiledScene compiled(scene);
    for (const auto& pass : compiled.passes()) {
      if (pass.isInUse) in += pass.name + "; ";
    }
    return in;
  };
  EXPECT_EQ(partsOf({.model = spec(false)}), "sphere packing; torque about the tool's axis; ");
  EXPECT_EQ(
      partsOf({.model = spec(true)}),
      "sphere packing; removal of bone; torque about the tool's axis; ");
  EXPECT_FALSE(problemsOf({.model = PackingSpec{}}).empty());
  const auto spoilt = [&](auto spoil) {
    auto bone = *parametricBone();
    spoil(bone);
    auto with = spec(true);
    with.bone = std::make_shared<reaming::PackedBone>(std::move(bone));
    return !problemsOf({.model = with}).empty();
  };
  EXPECT_FALSE(spoilt([](auto&) {}));
  EXPECT_TRUE(spoilt([](auto& bone) { bone.packing.volume = 1e-12; }));
  EXPECT_TRUE(spoilt([](auto& bone) { bone.packing.spheres[0].radius = 0.03F; }));
  EXPECT_TRUE(spoilt([](auto& bone) { bone.packing.spheres[0].x = 3e38F * 10.0F; }));
  EXPECT_TRUE(spoilt([](auto& bone) {
    for (auto& s : bone.packing.spheres) s.x += 0.5F;
  }));
  auto hard = spec(true);
  hard.hardness = 1.5;
  EXPECT_FALSE(problemsOf({.model = hard}).empty());
}

}  // namespace packing_model_test
}  // namespace haptics::engine
