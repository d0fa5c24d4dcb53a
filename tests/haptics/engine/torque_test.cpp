// The torque about the tool's axis: of the curve, of the spheres, and as the engine renders it.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/devices/iiwa/reamer_kind.h"
#include "haptics/devices/simulated_device.h"
#include "haptics/engine/bone_models.h"
#include "haptics/engine/built_in_models.h"
#include "haptics/engine/compiled_scene.h"
#include "haptics/engine/force_engine.h"
#include "haptics/reaming/bone/sphere_field.h"
#include "haptics/reaming/packing/packed_bone.h"
#include "haptics/reaming/packing/packing_builder.h"
#include "haptics/reaming/packing/solids.h"

namespace haptics::engine {
namespace torque_test {

constexpr double kInner = 0.0255;  // of the cup [m]
constexpr double kReamer = 0.026;  // [m]
constexpr double kPressure = 2e5;  // at which the bone gives way [N/m²]
constexpr double kFriction = 0.3;
constexpr double kDeepest = 0.015;  // [m]
constexpr double kScale = 0.15;

/// The angles from the axis between which a reamer at the height c touches a cup of one density:
/// where its surface is farther than the inner radius from the cup's centre, and below the rim,
///
///     |c z + R n|² ≥ a²,    c + R cos θ ≥ 0.
struct Patch {
  double from = 0.0;
  double to = 0.0;
};

Patch patchAt(double c) {
  const double rim = std::acos(std::clamp(-c / kReamer, 0.0, 1.0));
  if (c >= 0.0) return {0.0, rim};
  const double inner = (kInner * kInner - c * c - kReamer * kReamer) / (2.0 * c * kReamer);
  return {std::min(rim, std::acos(std::clamp(inner, -1.0, 1.0))), rim};
}

/// ∫ p cos θ dA and μ ∫ p R sin θ dA over the patch.
double forceAt(double c) {
  const auto [from, to] = patchAt(c);
  const double share = std::pow(std::sin(to), 2) - std::pow(std::sin(from), 2);
  return kPressure * std::numbers::pi * kReamer * kReamer * share;
}
double torqueAt(double c) {
  const auto [from, to] = patchAt(c);
  const auto part = [](double angle) { return angle - std::sin(angle) * std::cos(angle); };
  return kFriction * kPressure * std::numbers::pi * std::pow(kReamer, 3) * (part(to) - part(from));
}

/// A spline through a closed form, from first touch on.
reaming::HardnessCurves splineOf(double start, double (*exact)(double)) {
  constexpr int kNodes = 300;
  constexpr double kStep = kDeepest / kNodes;
  reaming::CurveNodes nodes;
  for (int i = 0; i <= kNodes; ++i) {
    const double c = start + i * kStep;
    const double slope = (exact(c + 0.1 * kStep) - exact(c - 0.1 * kStep)) / (0.2 * kStep);
    nodes.push_back({i * kStep, exact(c), slope});
  }
  return {nodes, nodes, nodes};
}

/// A cup of one density, as spheres and as a material.
struct HomogeneousCup {
  std::shared_ptr<reaming::PackedBone> bone = std::make_shared<reaming::PackedBone>();
  reaming::HardnessCurves force;
  reaming::HardnessCurves torque;

  HomogeneousCup() {
    bone->packing = *reaming::pack(reaming::Acetabulum(), {.count = 6000});
    const std::vector<float> alike(bone->packing.spheres.size(), static_cast<float>(kPressure));
    bone->minimum = bone->average = bone->maximum = alike;
    const reaming::SphereField field(bone->packing, bone->densities(0.5, 1.0));
    const auto plunge = reaming::plungePathInto(field, bone->reamerRadius);
    force = splineOf(plunge.start, forceAt);
    torque = splineOf(plunge.start, torqueAt);
  }
};

const HomogeneousCup& cup() {
  static const HomogeneousCup cup;
  return cup;
}

MaterialSpec material() {
  return {.nodes = {}, .curves = cup().force, .torque = cup().torque, .forceScale = kScale};
}

PackingSpec packing(bool isRemoved) {
  PackingSpec spec{.bone = cup().bone, .forceScale = kScale, .isRemoved = isRemoved};
  spec.options.friction = kFriction;
  return spec;
}

constexpr Reamer turning(double speed) {
  return {.speed = speed};
}

TEST(Torque, OfAMaterialIsItsCurveAgainstTheSpin) {
  MaterialModel forwards(material(), turning(5.0));
  MaterialModel backwards(material(), turning(-5.0));
  const auto curve = reaming::curveOf(cup().torque, 0.5);
  for (const double depth : {0.002, 0.004, 0.006, 0.010, 0.014}) {
    const double wanted = kScale * reaming::forceOf(curve, depth);
    ASSERT_GT(wanted, 0.01);
    forwards.respond({.travel = depth});
    backwards.respond({.travel = depth});
    EXPECT_NEAR(forwards.torque(), -wanted, 1e-12);
    EXPECT_NEAR(backwards.torque(), wanted, 1e-12);
  }
  forwards.respond({.travel = -0.001});
  EXPECT_EQ(forwards.torque(), 0.0) << "nothing is touched";
}

TEST(Torque, IsNoneWhereTheReamerStandsStill) {
  const auto still = turning(0.0);
  MaterialModel curve(material(), still);
  PackingModel spheres(packing(false), still);
  RemovalModel cut(packing(true), false, still);
  for (ForceModel* model : std::initializer_list<ForceModel*>{&curve, &spheres, &cut}) {
    EXPECT_FALSE(model->hasTorque());
    for (int i = 0; i < 100; ++i) model->respond({.travel = 1e-4 * i});
    EXPECT_EQ(model->torque(), 0.0);
  }
}

TEST(Torque, IsNoneWhileTheReamerIsSwitchedOff) {
  MaterialModel curve(material(), turning(5.0));
  PackingModel spheres(packing(false), turning(5.0));
  RemovalModel cut(packing(true), false, turning(5.0));
  while (!cut.respond({.travel = -0.0005}).isDefined) {
  }
  for (ForceModel* model : std::initializer_list<ForceModel*>{&curve, &spheres, &cut}) {
    for (int i = 0; i < 80; ++i) model->respond({.travel = 1e-4 * i});
    EXPECT_LT(model->torque(), 0.0);
    model->respond({.travel = 0.008, .isReamerOn = false});
    EXPECT_EQ(model->torque(), 0.0);
  }
}

TEST(Torque, IsNoneWhereNoneWasMeasured) {
  auto pressed = material();
  pressed.torque = {};
  MaterialModel model(pressed, turning(5.0));
  model.respond({.travel = 0.01});
  EXPECT_FALSE(model.hasTorque());
  EXPECT_EQ(model.torque(), 0.0);
  EXPECT_FALSE(hasTorque({.model = pressed}));
  EXPECT_TRUE(hasTorque({.model = material()}));
  EXPECT_FALSE(hasTorque({.model = FiniteElementsSpec{}}));
}

TEST(Torque, OfSpheresIsThatOfTheMaterialOnAHomogeneousCup) {
  PackingModel spheres(packing(false), turning(5.0));
  MaterialModel curve(material(), turning(5.0));
  double off[2] = {};
  double square[2] = {};
  for (double depth = 0.0005; depth < kDeepest; depth += 0.0002) {
    const double felt[]{spheres.respond({.travel = depth}).force, spheres.torque()};
    const double wanted[]{curve.respond({.travel = depth}).force, curve.torque()};
    for (int i : {0, 1}) {
      off[i] += std::pow(felt[i] - wanted[i], 2);
      square[i] += std::pow(wanted[i], 2);
    }
    // Once all of the reamer is in bone, the lever arm of the spheres is that of the closed form.
    if (depth > 0.007) {
      EXPECT_NEAR(felt[1] / felt[0], wanted[1] / wanted[0], 0.05 * std::abs(wanted[1] / wanted[0]));
    }
  }
  // Spheres fill a cup only roughly near its surface: of 6,000 the force is off by 18 %, of 60,000
  // by 10 %. The torque is as good as the force.
  const double ofForce = std::sqrt(off[0] / square[0]);
  const double ofTorque = std::sqrt(off[1] / square[1]);
  EXPECT_LT(ofForce, 0.25);
  EXPECT_LT(ofTorque, 1.25 * ofForce);
}

// docs/decisions/0059: by the force alone, spheres at the rim get a density that is far too large
// for the torque.
TEST(Torque, OfSpheresIsThatOfTheCupOnceTheirDensitiesWereFittedToForceAndTorque) {
  auto bone = *cup().bone;
  const auto alike = reaming::fitFriction(bone, cup().torque);
  EXPECT_NEAR(alike.friction, kFriction, 0.05 * kFriction);
  EXPECT_LT(alike.error, 0.25);

  constexpr std::size_t kDepths = 100;
  reaming::fitBoneToMaterial(bone, cup().force, {}, {.depths = kDepths});
  EXPECT_GT(reaming::fitFriction(bone, cup().torque).error, 0.4) << "by the force alone";

  const auto both =
      reaming::fitBoneToMaterial(bone, cup().force, cup().torque, {.depths = kDepths});
  EXPECT_LT(both.curves[1].fit.spheres.error, 0.06);
  EXPECT_LT(both.curves[1].torqueError.value(), 0.06);
  EXPECT_LT(both.curves[1].fit.spheres.gap, 1e-6);
  EXPECT_EQ(bone.friction, both.friction);

  // With the friction that the cup has, spheres cannot fill its rim well enough for less.
  const auto known = reaming::fitBoneToMaterial(
      bone, cup().force, cup().torque, {.depths = kDepths, .friction = kFriction});
  EXPECT_EQ(bone.friction, kFriction);
  EXPECT_LT(known.curves[1].fit.spheres.error, 0.12);
  EXPECT_LT(known.curves[1].torqueError.value(), 0.07);
}

TEST(Torque, OfTheBuiltInBoneIsThatOfItsMaterial) {
  EXPECT_LT(reaming::fitFriction(*parametricBone(), parametricTorque()).error, 0.02);
}

TEST(Torque, OfSpheresHasTheFrictionThatWasFittedToIt) {
  // Of the torque of these very spheres, so that nothing but the fit is looked at.
  PackingModel spheres(packing(false), turning(-5.0));
  reaming::CurveNodes nodes;
  for (int i = 0; i <= 150; ++i) {
    spheres.respond({.travel = 1e-4 * i});
    nodes.push_back({1e-4 * i, spheres.torque() / kScale, 0.0});
  }
  for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
    nodes[i].slope = (nodes[i + 1].force - nodes[i - 1].force) / 2e-4;
  }
  const auto fit = reaming::fitFriction(*cup().bone, {nodes, nodes, nodes});
  EXPECT_NEAR(fit.friction, kFriction, 0.01 * kFriction);
  EXPECT_LT(fit.error, 0.02);
  EXPECT_THROW(
      reaming::fitFriction(
          *cup().bone,
          {{{0.0, 0.0, 0.0}, {0.01, 0.0, 0.0}},
           {{0.0, 0.0, 0.0}, {0.01, 0.0, 0.0}},
           {{0.0, 0.0, 0.0}, {0.01, 0.0, 0.0}}}),
      std::invalid_argument);
}

TEST(Torque, OfSpheresThatAreCutIsThatOfThoseThatStay) {
  RemovalModel cut(packing(true), false, turning(5.0));
  PackingModel stay(packing(false), turning(5.0));
  while (!cut.respond({.travel = -0.0005}).isDefined) {
  }
  double difference = 0.0;
  double square = 0.0;
  for (double travel = -0.0005; travel < 0.010; travel += 2e-6) {
    const double force = cut.respond({.travel = travel, .dt = 0.01}).force;
    stay.respond({.travel = travel - force / cut.largestStiffness()});
    difference += std::pow(cut.torque() - stay.torque(), 2);
    square += std::pow(stay.torque(), 2);
  }
  EXPECT_LT(std::sqrt(difference / square), 0.05);
}

TEST(Torque, OfSpheresGrowsWithFriction) {
  const auto at = [](double friction) {
    auto spec = packing(false);
    spec.options.friction = friction;
    PackingModel model(spec, turning(5.0));
    model.respond({.travel = 0.008});
    return model.torque();
  };
  EXPECT_NEAR(at(2.0) / at(0.1), 20.0, 1e-9);
  EXPECT_EQ(at(0.0), 0.0);
}

/// A reamer that stands where it is put, and gives a torque or not.
class HeldReamer final : public devices::Device {
 public:
  explicit HeldReamer(double maxTorque) { capabilities_.maxTorque = maxTorque; }
  const devices::Capabilities& capabilities() const noexcept override { return capabilities_; }
  devices::DeviceSample read(double /*dt*/) noexcept override { return sample; }
  void command(double force, double torque) noexcept override {
    commandedForce = force;
    commandedTorque = torque;
  }

  devices::DeviceSample sample{.status = devices::DeviceStatus::Ok};
  double commandedForce = 0.0;
  double commandedTorque = 0.0;

 private:
  devices::Capabilities capabilities_ = devices::simulated(devices::reamerKind());
};

constexpr SafetyLimits kLimits{
    .maxForce = 140.0, .maxRate = 5000.0, .maxTorque = 5.0, .maxTorqueRate = 50.0};
constexpr double kDt = 0.001;

/// An engine that renders the material on a held reamer.
struct Rendering {
  explicit Rendering(double speed, const SafetyLimits& limits = kLimits, double deviceTorque = 10.0)
      : device(deviceTorque),
        engine(device, limits),
        scene({.model = material(), .reamer = turning(speed)}) {
    engine.setScene(&scene);
    stayAt(0.0, 150);  // so that the force comes on
  }
  TickSample stayAt(double travel, int ticks) {
    device.sample.travel = travel;
    TickSample sample;
    for (int i = 0; i < ticks; ++i) sample = engine.tick(kDt);
    return sample;
  }

  HeldReamer device;
  ForceEngine engine;
  CompiledScene scene;
};

TEST(ForceEngine, CommandsTheTorqueOfTheScene) {
  Rendering rendering(5.0);
  const auto curve = reaming::curveOf(cup().torque, 0.5);
  for (const double depth : {0.002, 0.004, 0.006, 0.010, 0.014}) {
    const auto sample = rendering.stayAt(depth, 200);
    EXPECT_NEAR(sample.torque, -kScale * reaming::forceOf(curve, depth), 1e-9) << depth;
    EXPECT_EQ(sample.torque, sample.desiredTorque);
    EXPECT_EQ(sample.torque, rendering.device.commandedTorque);
  }
  rendering.engine.stop();
  EXPECT_EQ(rendering.stayAt(0.014, 1).torque, 0.0);
  EXPECT_EQ(rendering.device.commandedTorque, 0.0);
}

TEST(ForceEngine, KeepsATorqueWithinItsSizeAndRate) {
  auto limits = kLimits;
  limits.maxTorque = 0.1;
  limits.maxTorqueRate = 2.0;
  Rendering rendering(5.0, limits);
  double last = rendering.stayAt(0.0, 1).torque;
  bool isSaturated = false;
  bool isSlewed = false;
  for (int i = 0; i < 400; ++i) {
    const auto sample = rendering.stayAt(i / 100 % 2 == 0 ? 0.014 : 0.0, 1);
    ASSERT_LE(std::abs(sample.torque), limits.maxTorque);
    ASSERT_LE(std::abs(sample.torque - last), limits.maxTorqueRate * kDt * (1.0 + 1e-9));
    isSaturated |= (sample.interventions & ForceLimiter::TorqueSaturated) != 0;
    isSlewed |= (sample.interventions & ForceLimiter::TorqueSlewed) != 0;
    last = sample.torque;
  }
  EXPECT_TRUE(isSaturated);
  EXPECT_TRUE(isSlewed);
}

TEST(ForceEngine, GivesNoTorqueToADeviceThatRendersNone) {
  Rendering rendering(5.0, kLimits, 0.0);
  const auto sample = rendering.stayAt(0.014, 200);
  EXPECT_LT(sample.desiredTorque, -0.1);
  EXPECT_EQ(sample.torque, 0.0);
  EXPECT_EQ(rendering.device.commandedTorque, 0.0);
  EXPECT_GT(rendering.device.commandedForce, 1.0);
}

TEST(ForceEngine, ObservesTheEnergyOfTheTurn) {
  Rendering rendering(5.0);
  const double torque = rendering.stayAt(0.014, 200).torque;
  const double before = rendering.stayAt(0.014, 1).rotationEnergy;
  EXPECT_EQ(before, 0.0) << "a wrist that does not yield takes up nothing";
  // A wrist that yields by 0.1 rad the way that it is turned is given |torque| · 0.1 J.
  TickSample sample;
  for (int i = 0; i < 100; ++i) {
    rendering.device.sample.turn += std::copysign(0.001, torque);
    sample = rendering.engine.tick(kDt);
  }
  EXPECT_NEAR(sample.rotationEnergy, -0.1 * std::abs(torque), 1e-9);
  EXPECT_NE(sample.interventions & ForceLimiter::TorqueActive, 0);
  EXPECT_EQ(sample.interventions & ForceLimiter::Active, 0);
}

}  // namespace torque_test
}  // namespace haptics::engine
