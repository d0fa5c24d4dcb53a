#include "haptics/engine/force_engine.h"

#include <cmath>

#include <gtest/gtest.h>

#include "haptics/devices/simulated_device.h"
#include "haptics/devices/simulated_hand.h"
#include "haptics/engine/parametric_material.h"
#include "tests/support/allocation_counter.h"

namespace haptics::engine {
namespace {

constexpr double kDt = 0.001;

/// A device that stands where it is put.
class HeldDevice final : public devices::Device {
 public:
  const devices::Capabilities& capabilities() const noexcept override { return capabilities_; }
  devices::DeviceSample read(double /*dt*/) noexcept override { return sample; }
  void command(double force) noexcept override { commanded = force; }

  devices::DeviceSample sample{.status = devices::DeviceStatus::Ok};
  double commanded = 0.0;

 private:
  devices::Capabilities capabilities_ = devices::simulatedPunch();
};

SceneSpec finiteElements() { return {.model = FiniteElementsSpec{}}; }

class ForceEngineTest : public testing::Test {
 protected:
  double feelAt(double travel) {
    device_.sample.travel = travel;
    TickSample sample;
    for (int i = 0; i < 100; ++i) sample = engine_.tick(kDt);
    return sample.force;
  }

  HeldDevice device_;
  ForceEngine engine_{device_, {.maxForce = 6.0, .maxRate = 300.0}};
  CompiledScene scene_{finiteElements()};
};

TEST_F(ForceEngineTest, LetsTheHandFeelTheScene) {
  engine_.setScene(&scene_);
  EXPECT_NEAR(feelAt(5.0), 1.714, 5e-4);  // one unit into the tissue at 1.714 N/unit
  EXPECT_EQ(device_.commanded, feelAt(5.0));
}

TEST_F(ForceEngineTest, PushesNobodyWithoutAScene) {
  EXPECT_EQ(feelAt(5.0), 0.0);
  EXPECT_TRUE((engine_.tick(kDt).marks & TickSample::Bare) != 0);
}

TEST_F(ForceEngineTest, SaysWhenTheSceneAsksForMoreThanIsAllowed) {
  engine_.setScene(&scene_);
  EXPECT_EQ(feelAt(9.0), 6.0);  // the scene wants 7 N
  const auto sample = engine_.tick(kDt);
  EXPECT_EQ(sample.desired, 7.0);
  EXPECT_TRUE((sample.interventions & ForceLimiter::Saturated) != 0);
}

TEST_F(ForceEngineTest, LetsGoInTheSameTickWhenStopped) {
  engine_.setScene(&scene_);
  feelAt(6.0);
  engine_.stop();
  EXPECT_EQ(engine_.tick(kDt).force, 0.0);
  EXPECT_EQ(device_.commanded, 0.0);
  engine_.arm();
  EXPECT_LE(engine_.tick(kDt).force, 0.3 + 1e-12);  // comes back no faster than 300 N/s
}

TEST_F(ForceEngineTest, LetsGoOfADeviceThatIsGoneAndStaysStoppedWhenItIsBack) {
  engine_.setScene(&scene_);
  feelAt(6.0);
  device_.sample.status = devices::DeviceStatus::Gone;
  const auto gone = engine_.tick(kDt);
  EXPECT_EQ(gone.force, 0.0);
  EXPECT_TRUE((gone.marks & TickSample::Invalid) != 0);
  EXPECT_EQ(gone.travel, 6.0);  // the last one, marked; not a plausible zero
  device_.sample.status = devices::DeviceStatus::Ok;
  EXPECT_EQ(engine_.tick(kDt).force, 0.0);
  EXPECT_TRUE(engine_.isStopped());
}

TEST_F(ForceEngineTest, LetsGoOfAStaleSampleAndGoesOnAfterIt) {
  engine_.setScene(&scene_);
  feelAt(6.0);
  device_.sample.status = devices::DeviceStatus::Stale;
  EXPECT_EQ(engine_.tick(kDt).force, 0.0);
  device_.sample.status = devices::DeviceStatus::Ok;
  EXPECT_GT(engine_.tick(kDt).force, 0.0);
}

TEST_F(ForceEngineTest, NeverCommandsWhatIsNoNumber) {
  engine_.setScene(&scene_);
  for (const double bad : {std::nan(""), double{INFINITY}, -double{INFINITY}, 1e308, -1e308}) {
    device_.sample.travel = bad;
    engine_.tick(kDt);
    EXPECT_TRUE(std::isfinite(device_.commanded)) << bad;
    EXPECT_LE(std::abs(device_.commanded), 6.0) << bad;
  }
}

TEST_F(ForceEngineTest, FeelsAgainAfterALeapThatNoHandMakes) {
  KalmanSpec both;
  both.interpolation.curve = {{3.0, 0.0}, {7.0, 4.0}, {9.0, 2.0}};
  CompiledScene kalman({.model = both});
  engine_.setScene(&kalman);
  const double before = feelAt(6.0);
  for (const double leap : {1e308, -1e308, 1e155, std::nan("")}) {
    device_.sample.travel = leap;
    engine_.tick(kDt);
    EXPECT_TRUE(std::isfinite(device_.commanded));
    EXPECT_NEAR(feelAt(6.0), before, 0.05) << leap;
  }
}

TEST_F(ForceEngineTest, AllocatesNothingInATickWhateverTheScene) {
  CompiledScene interpolation({.model = InterpolationSpec{.curve = {{3.0, 0.0}, {7.0, 4.0}}}});
  KalmanSpec both;
  both.interpolation.curve = {{3.0, 0.0}, {7.0, 4.0}, {9.0, 2.0}};
  CompiledScene kalman({.model = both, .isVisualised = true});
  CompiledScene material(
      {.device = devices::DeviceKind::Reamer, .model = MaterialSpec{.nodes = parametricMaterial()}});
  for (auto* scene : {&interpolation, &scene_, &kalman, &material}) {
    engine_.setScene(scene);
    const tests::AllocationCounter allocations;
    for (int i = 0; i < 1000; ++i) {
      device_.sample.travel = 5.0 + 5.0 * std::sin(0.01 * i);
      engine_.tick(kDt);
    }
    EXPECT_EQ(allocations.count(), 0U);
  }
}

TEST_F(ForceEngineTest, CountsEachCutOnceAndAnewForEachScene) {
  const auto closeAndOpen = [&] {
    for (int i = 0; i <= 200; ++i) {
      device_.sample.travel = 10.0 * std::sin(3.14159265358979 * i / 200);
      engine_.tick(kDt);
    }
  };
  engine_.setScene(&scene_);
  for (int i = 0; i < 3; ++i) closeAndOpen();
  EXPECT_EQ(engine_.tick(kDt).cuts, 3U);
  CompiledScene other(finiteElements());
  engine_.setScene(&other);
  EXPECT_EQ(engine_.tick(kDt).cuts, 0U);
}

TEST(SimulatedPunch, IsCutByASimulatedHandThroughTheEngine) {
  devices::SimulatedHand hand({});
  devices::SimulatedDevice device(devices::simulatedPunch(), devices::punchMechanism(), hand);
  ForceEngine engine(device, {.maxForce = 8.0, .maxRate = 500.0});
  CompiledScene scene(finiteElements());
  engine.setScene(&scene);
  TickSample sample;
  double peak = 0.0;
  for (int i = 0; i < 10'000; ++i) {
    sample = engine.tick(kDt);
    peak = std::max(peak, sample.force);
    ASSERT_LT(std::abs(sample.travel), 12.0);
  }
  EXPECT_GE(sample.cuts, 5U);  // 10 s at 1.65 s a cut
  EXPECT_NEAR(peak, 7.0, 0.01);
}

TEST(SimulatedReamer, IsPushedByASimulatedHandThroughTheEngine) {
  devices::SimulatedHand hand(
      {.closed = 0.035, .closeTime = 1.5, .openTime = 1.0, .stiffness = 6000.0, .damping = 150.0});
  devices::SimulatedDevice device(devices::simulatedReamer(), devices::reamerMechanism(), hand);
  ForceEngine engine(device, {.maxForce = 140.0, .maxRate = 5000.0});
  MaterialSpec bone{.nodes = parametricMaterial(), .hardness = 0.5, .forceScale = 0.15};
  CompiledScene scene({.device = devices::DeviceKind::Reamer, .model = bone});
  engine.setScene(&scene);
  TickSample sample;
  double peak = 0.0;
  for (int i = 0; i < 10'000; ++i) {
    sample = engine.tick(kDt);
    peak = std::max(peak, sample.force);
  }
  EXPECT_GE(sample.cuts, 2U);
  EXPECT_GT(peak, 20.0);
  EXPECT_LT(peak, 140.0);
}

}  // namespace
}  // namespace haptics::engine
