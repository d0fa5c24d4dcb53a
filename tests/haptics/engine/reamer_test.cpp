// How fast a reamer goes through bone: of spheres, and of a curve. References are closed forms of
// feed = speed · teeth · feed per tooth and of the spring's law, and the measured curve itself.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "haptics/devices/iiwa/reamer_kind.h"
#include "haptics/devices/simulated_device.h"
#include "haptics/engine/bone_models.h"
#include "haptics/engine/built_in_models.h"
#include "haptics/engine/compiled_scene.h"
#include "haptics/engine/force_engine.h"
#include "haptics/engine/reamed_material.h"
#include "haptics/engine/scene_spec.h"
#include "tests/support/allocation_counter.h"

namespace haptics::engine {
namespace reamer_test {

constexpr double kTick = 0.001;  // [s]
constexpr double kScale = 0.15;  // of all forces
constexpr double kCoupling = ReamedMaterialModel::kCoupling;

/// A bone of spheres, its resistance and its tool.
struct Spheres {
  explicit Spheres(const Reamer& reamer)
      : model({.bone = parametricBone(), .forceScale = kScale}, false, reamer) {
    while (!model.isReady()) model.respond({.travel = 0.0, .dt = kTick});
    model.respond({.travel = 0.0, .dt = kTick});
    surface = model.bone().tool().centre.z;
  }
  double depth() const { return model.bone().tool().centre.z - surface; }
  double resistance() const {
    const auto& bone = model.bone();
    return -bone.field().touch(bone.tool(), true).force.z / bone.coverage();
  }
  double removed() const { return model.bone().removedMass(); }

  RemovalModel model;
  double surface = 0.0;
};

/// A curve, its resistance and its tool.
struct Curve {
  explicit Curve(const Reamer& reamer)
      : spec{.nodes = parametricMaterial(), .forceScale = kScale, .isRemoved = true},
        model(spec, reamer),
        still(spec) {}
  double depth() const { return model.depth(); }
  double resistance() { return still.respond({.travel = depth()}).force; }
  double removed() const { return depth(); }

  MaterialSpec spec;
  ReamedMaterialModel model;
  MaterialModel still;
};

/// A device that pushes with a force of its own: that far beyond the tool it stretches the spring.
template <typename Bone>
double push(Bone& bone, double newtons, double dt = kTick) {
  return bone.model.respond({.travel = bone.depth() + newtons / kCoupling, .dt = dt}).force;
}

/// How fast bone of which @p reamer has reached 4 mm gives way to @p newtons above its resistance
/// [m/s].
template <typename Bone>
double feedAbove(double newtons, const Reamer& reamer) {
  Bone bone(reamer);
  constexpr double kCoarse = 0.02;  // [s]
  for (int i = 0; i < 1000 && bone.depth() < 0.004; ++i) {
    push(bone, bone.resistance() + 10.0, kCoarse);
  }
  // In a short step the spring lets go of next to nothing of the push.
  constexpr double kFine = 1e-4;  // [s]
  constexpr int kTicks = 300;
  const double before = bone.depth();
  for (int i = 0; i < kTicks; ++i) push(bone, bone.resistance() + newtons, kFine);
  return (bone.depth() - before) / (kTicks * kFine);
}

template <typename Bone>
class ReamerTest : public testing::Test {};
using Bones = testing::Types<Spheres, Curve>;
TYPED_TEST_SUITE(ReamerTest, Bones);

TYPED_TEST(ReamerTest, GoesNoFasterThanSpeedTimesTeethTimesFeedPerTooth) {
  // 5/s · 4 · 0.1 mm; without that limit, 10 N would give 10 N / (0.15 · 2000 N·s/m) = 33 mm/s.
  EXPECT_NEAR(feedAbove<TypeParam>(10.0, {}), 0.002, 1e-6);
  EXPECT_NEAR(feedAbove<TypeParam>(100.0, {}), 0.002, 1e-6);
  EXPECT_NEAR(feedAbove<TypeParam>(10.0, {.feedPerTooth = 0.05e-3}), 0.001, 1e-6);
}

TYPED_TEST(ReamerTest, GoesTwiceAsFastWithTwiceTheSpeedOrTwiceTheTeeth) {
  // Below its limit as well: there b v = F − R, and b falls with the teeth that pass in a second.
  for (const double newtons : {0.3, 10.0}) {
    const double usual = feedAbove<TypeParam>(newtons, {});
    EXPECT_NEAR(feedAbove<TypeParam>(newtons, {.speed = 10.0}), 2.0 * usual, 0.1 * usual);
    EXPECT_NEAR(feedAbove<TypeParam>(newtons, {.teeth = 8}), 2.0 * usual, 0.1 * usual);
  }
}

TYPED_TEST(ReamerTest, RemovesNothingWhileItStandsStillOrTurnsBackwards) {
  for (const double speed : {0.0, -5.0}) {
    TypeParam bone({.speed = speed});
    for (int i = 0; i < 100; ++i) push(bone, 100.0);  // up to the bone, and against it
    const double there = bone.depth();
    const double removed = bone.removed();
    for (int i = 0; i < 10'000; ++i) ASSERT_NEAR(push(bone, 100.0), 100.0, 1e-6);
    EXPECT_EQ(bone.depth(), there);
    EXPECT_EQ(bone.removed(), removed);
  }
}

TYPED_TEST(ReamerTest, HasNoFeedLimitInStudiesOfRelease01) {
  // The spring's law alone: 10 N / K / (1 + 0.15 · 2000 N·s/m / (K · 1 ms)) in a tick, 28.6 mm/s.
  const double wanted = 10.0 / kCoupling / (1.0 + kScale * 2000.0 / (kCoupling * kTick)) / kTick;
  EXPECT_NEAR(wanted, 0.0286, 1e-4);
  TypeParam bone(Reamer::withoutFeedLimit());
  for (int i = 0; i < 10'000 && bone.depth() < 0.004; ++i) push(bone, bone.resistance() + 10.0);
  const double before = bone.depth();
  push(bone, bone.resistance() + 10.0);
  EXPECT_NEAR(bone.depth() - before, wanted * kTick, 1e-9);
}

TYPED_TEST(ReamerTest, RemovesNothingWhileItIsSwitchedOff) {
  TypeParam bone({});
  const auto pushFor = [&](int ticks, bool isOn) {
    for (int i = 0; i < ticks; ++i) {
      const double travel = bone.depth() + (bone.resistance() + 10.0) / kCoupling;
      bone.model.respond({.travel = travel, .dt = kTick, .isReamerOn = isOn});
    }
    return bone.depth();
  };
  const double before = pushFor(500, true);
  EXPECT_EQ(pushFor(500, false), before);
  EXPECT_NEAR(pushFor(500, true), before + 0.001, 1e-6);
}

/// @return  how far the force is off the curve at @p feed [m/s], in all: |felt − curve| / |curve|.
double errorOfSpheres(double feed) {
  const auto curve = reaming::curveOf(parametricCurves(), 0.5);
  Spheres bone({});
  const double dt = 2e-6 / feed;
  double difference = 0.0;
  double square = 0.0;
  for (double travel = 0.0; travel < 0.008; travel += 2e-6) {
    const double felt = bone.model.respond({.travel = travel, .dt = dt}).force;
    if (travel < 0.003) continue;
    const double wanted = kScale * reaming::forceOf(curve, bone.depth());
    difference += (felt - wanted) * (felt - wanted);
    square += wanted * wanted;
  }
  return std::sqrt(difference / square);
}

TEST(Reamer, GivesBackTheMeasuredForceAtTheMeasuredFeedsFromSpheres) {
  // The fit's own error: the intact bone against the curve that it was fitted to.
  const auto curve = reaming::curveOf(parametricCurves(), 0.5);
  PackingModel intact({.bone = parametricBone(), .forceScale = kScale, .isRemoved = false});
  double difference = 0.0;
  double square = 0.0;
  for (double depth = 0.003; depth < 0.008; depth += 2e-6) {
    const double wanted = kScale * reaming::forceOf(curve, depth);
    difference += std::pow(intact.respond({.travel = depth}).force - wanted, 2.0);
    square += wanted * wanted;
  }
  const double fit = std::sqrt(difference / square);
  EXPECT_LT(fit, 0.02);
  for (const double feed : {0.01e-3, 0.03e-3}) {
    EXPECT_LT(errorOfSpheres(feed), fit + 0.01) << feed;
  }
}

TEST(Reamer, GivesBackTheMeasuredForceAtTheMeasuredFeedsFromACurve) {
  for (const double feed : {0.01e-3, 0.03e-3}) {
    Curve bone({});
    const double dt = 1e-6 / feed;
    for (double travel = 0.0; travel < 0.019; travel += 1e-6) {
      const double felt = bone.model.respond({.travel = travel, .dt = dt}).force;
      if (travel < 0.001) continue;
      // b v is 0.15 · 2000 N·s/m · 0.03 mm/s = 0.009 N; the spring lags by a step at most.
      ASSERT_NEAR(felt, bone.resistance(), 0.06) << feed << " " << travel;
    }
  }
}

TEST(Reamer, NeedsAForceThatGrowsWithTheFeed) {
  double before = 0.0;
  for (const double feed : {0.1e-3, 0.3e-3, 1e-3}) {
    Curve bone({});
    double felt = 0.0;
    for (double travel = 0.0; travel < 0.006; travel += feed * kTick) {
      felt = bone.model.respond({.travel = travel, .dt = kTick}).force;
    }
    // b v; where the curve falls the spring adds some of what it had stored to the feed.
    const double wanted = kScale * 2000.0 * feed;
    EXPECT_NEAR(felt - bone.resistance(), wanted, 0.1 * wanted) << feed;
    EXPECT_GT(felt - bone.resistance(), before) << feed;
    before = felt - bone.resistance();
  }
}

TEST(ForceEngine, TurnsAReamerWhileItsPedalAndTheDevicesSwitchAreOn) {
  const auto removedIn = [](bool isDeviceOn, bool isPedalOn) {
    devices::SimulatedHand hand(
        {.open = 0.0, .closed = 0.02, .pauseTime = 0.0, .stiffness = 4000.0, .damping = 200.0});
    devices::SimulatedDevice device(devices::reamerKind(), hand);
    ForceEngine engine(device, {.maxForce = 140.0, .maxRate = 5000.0, .maxVelocity = 1.0});
    CompiledScene scene(
        {.model =
             MaterialSpec{.nodes = parametricMaterial(), .forceScale = 0.15, .isRemoved = true}});
    engine.setScene(&scene);
    engine.switchReamer(isPedalOn);
    device.switchReamer(isDeviceOn);
    double deepest = 0.0;
    for (int i = 0; i < 1000; ++i) {
      const auto sample = engine.tick(kTick);
      // Where the spring that carries the force begins is how far bone has been removed.
      deepest = std::max(deepest, sample.travel - sample.desired / kCoupling);
    }
    return deepest;
  };
  EXPECT_GT(removedIn(true, true), 0.0005);
  EXPECT_NEAR(removedIn(true, false), 0.0, 1e-12);
  EXPECT_NEAR(removedIn(false, true), 0.0, 1e-12);
}

TEST(ReamedMaterial, MeetsTheSameCurveInEveryStroke) {
  Curve bone({});
  double first = 0.0;
  for (int stroke = 0; stroke < 3; ++stroke) {
    double travel = 0.0;
    for (; travel < 0.006; travel += 1e-6) bone.model.respond({.travel = travel, .dt = kTick});
    const double felt = bone.model.respond({.travel = travel, .dt = kTick}).force;
    if (stroke == 0) first = felt;
    EXPECT_NEAR(felt, first, 1e-6);
    for (; travel > 0.0; travel -= 1e-5) {
      ASSERT_GE(bone.model.respond({.travel = travel, .dt = kTick}).force, 0.0);
    }
    EXPECT_EQ(bone.model.respond({.travel = -0.001, .dt = kTick}).force, 0.0);
    EXPECT_EQ(bone.depth(), 0.0);
  }
}

TEST(ReamedMaterial, StaysBoundedAndAllocatesNothingWithAnyMotion) {
  Curve bone({});
  const tests::AllocationCounter counter;
  for (const double travel : {0.015, 0.05, -0.01, 1e6, -1e6, 0.02}) {
    for (int i = 0; i < 300; ++i) {
      const double before = bone.depth();
      const auto felt = bone.model.respond({.travel = travel, .dt = kTick});
      ASSERT_TRUE(felt.isDefined);
      ASSERT_TRUE(std::isfinite(felt.force));
      ASSERT_LE(bone.depth() - before, 0.002 * kTick * 1.000001);
    }
  }
  bone.model.reset();
  EXPECT_EQ(counter.count(), 0U);
  EXPECT_EQ(bone.depth(), 0.0);
  EXPECT_FALSE(bone.model.respond({.travel = std::nan(""), .dt = kTick}).isDefined);
}

TEST(ReamedMaterial, AddsJitterOnlyWhileTheReamerTurns) {
  const auto largestRise = [](double speed) {
    MaterialSpec spec{.nodes = parametricMaterial(), .isRemoved = true};
    spec.jitter = {.rms = 1.0, .rate = 100.0};
    ReamedMaterialModel model(spec, {.speed = speed});
    double rise = 0.0;
    double before = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 1000; ++i) {
      const double force = model.respond({.travel = 0.02, .dt = kTick}).force;
      rise = std::max(rise, force - before);
      before = force;
    }
    return rise;
  };
  // On a device that stays where it is the spring's force falls as the reamer goes on, or stays.
  EXPECT_EQ(largestRise(0.0), 0.0);
  EXPECT_GT(largestRise(5.0), 0.1);
}

TEST(CompiledScene, DescribesTheFeedLimitOfTheReamer) {
  const auto removalOf = [](const SceneSpec& scene) {
    const CompiledScene compiled(scene);
    for (const auto& pass : compiled.passes()) {
      if (pass.name == "removal of bone") return (pass.isInUse ? "in: " : "out: ") + pass.why;
    }
    return std::string();
  };
  SceneSpec scene{.model = MaterialSpec{.nodes = parametricMaterial(), .isRemoved = true}};
  EXPECT_EQ(
      removalOf(scene),
      "in: the reamer goes on as it removes bone, at most 2 mm/s: 5 turns a second, 4 teeth, 0.1 "
      "mm "
      "per tooth");
  scene.reamer.speed = 0.0;
  EXPECT_EQ(
      removalOf(scene),
      "in: the reamer goes on as it removes bone; the reamer stands still, and removes nothing");
  scene.model = PackingSpec{.bone = parametricBone()};
  scene.reamer = Reamer::withoutFeedLimit();
  EXPECT_EQ(removalOf(scene), "in: what the reamer goes through is taken away");
}

TEST(Reamer, IsRefusedWithoutTeethOrFeed) {
  SceneSpec scene{.model = MaterialSpec{.nodes = parametricMaterial()}};
  EXPECT_TRUE(problemsOf(scene).empty());
  for (const Reamer& wrong :
       {Reamer{.speed = 101.0},
        Reamer{.speed = 1e-306},
        Reamer{.speed = -1e-306},
        Reamer{.speed = std::nan("")},
        Reamer{.teeth = 0},
        Reamer{.feedPerTooth = 0.0},
        Reamer{.feedPerTooth = std::nan("")}}) {
    scene.reamer = wrong;
    EXPECT_FALSE(problemsOf(scene).empty());
  }
  for (const double slow : {0.0, Reamer::kLeastSpeed, -Reamer::kLeastSpeed}) {
    scene = {.model = PackingSpec{.bone = parametricBone()}, .reamer = {.speed = slow}};
    EXPECT_TRUE(problemsOf(scene).empty()) << slow;
    EXPECT_NO_THROW(CompiledScene{scene}) << slow;
  }
}

}  // namespace reamer_test
}  // namespace haptics::engine
