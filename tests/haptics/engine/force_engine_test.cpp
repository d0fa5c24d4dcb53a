#include "haptics/engine/force_engine.h"

#include <cmath>

#include <gtest/gtest.h>

#include "haptics/devices/hand.h"
#include "haptics/devices/iiwa/reamer_kind.h"
#include "haptics/devices/punch/punch_kind.h"
#include "haptics/devices/simulated_device.h"
#include "haptics/engine/built_in_models.h"
#include "tests/support/allocation_counter.h"

namespace haptics::engine {
namespace force_engine_test {

constexpr double kDt = 0.001;

/// A device that stands where it is put.
class HeldDevice final : public devices::Device {
 public:
  const devices::Capabilities& capabilities() const noexcept override { return capabilities_; }
  devices::DeviceSample read(double /*dt*/) noexcept override { return sample; }
  void command(double force, double torque) noexcept override {
    commanded = force;
    commandedTorque = torque;
  }

  devices::DeviceSample sample{.status = devices::DeviceStatus::Ok};
  double commanded = 0.0;
  double commandedTorque = 0.0;

 private:
  devices::Capabilities capabilities_ = devices::simulated(devices::punchKind());
};

SceneSpec finiteElements() {
  return {.model = FiniteElementsSpec{}};
}

class ForceEngineTest : public testing::Test {
 protected:
  TickSample stayAt(double travel, int ticks) {
    device_.sample.travel = travel;
    TickSample sample;
    for (int i = 0; i < ticks; ++i) sample = engine_.tick(kDt);
    return sample;
  }

  /// Opens, so that the force comes on, and goes there.
  double feelAt(double travel) {
    stayAt(0.0, 150);
    return stayAt(travel, 100).force;
  }

  HeldDevice device_;
  ForceEngine engine_{device_, {.maxForce = 6.0, .maxRate = 300.0}};
  CompiledScene scene_{finiteElements()};
};

TEST_F(ForceEngineTest, RendersTheScene) {
  engine_.setScene(&scene_);
  EXPECT_NEAR(feelAt(5.0), 1.714, 5e-4);  // one unit into the tissue at 1.714 N/unit
  EXPECT_EQ(device_.commanded, feelAt(5.0));
}

TEST_F(ForceEngineTest, GivesNoForceWithoutAScene) {
  EXPECT_EQ(feelAt(5.0), 0.0);
  EXPECT_TRUE((engine_.tick(kDt).marks & TickSample::NoScene) != 0);
}

TEST_F(ForceEngineTest, ReportsSaturation) {
  engine_.setScene(&scene_);
  EXPECT_EQ(feelAt(9.0), 6.0);  // the scene wants 7 N
  const auto sample = engine_.tick(kDt);
  EXPECT_EQ(sample.desired, 7.0);
  EXPECT_TRUE((sample.interventions & ForceLimiter::Saturated) != 0);
}

TEST_F(ForceEngineTest, HasNoForceInTheTickOfAStop) {
  engine_.setScene(&scene_);
  feelAt(6.0);
  engine_.stop();
  EXPECT_EQ(engine_.tick(kDt).force, 0.0);
  EXPECT_EQ(device_.commanded, 0.0);
}

TEST_F(ForceEngineTest, StartsSoftlyAfterItIsArmedAgain) {
  engine_.setScene(&scene_);
  feelAt(6.0);
  engine_.stop();
  engine_.tick(kDt);
  engine_.arm();
  // The hand still presses: nothing, however long, until it asks for little.
  const auto pressed = stayAt(6.0, 1000);
  EXPECT_EQ(pressed.force, 0.0);
  EXPECT_NEAR(pressed.desired, 3.43, 0.01);
  EXPECT_TRUE((pressed.marks & TickSample::SoftStart) != 0);
  stayAt(4.1, 1);
  for (int i = 0; i < 99; ++i) {
    const auto coming = stayAt(5.0, 1);
    EXPECT_LE(coming.force, 1.7142858 * (i + 2) / 100.0 + 1e-9);
  }
  EXPECT_NEAR(stayAt(5.0, 2).force, 1.714, 5e-4);
  EXPECT_EQ(engine_.tick(kDt).marks, TickSample::None);
}

TEST_F(ForceEngineTest, CommandsNoForceInTheFirstTickAfterRearming) {
  engine_.setScene(&scene_);
  ASSERT_GT(feelAt(6.0), 3.0);  // ten times what the limit lets the force change in a tick
  engine_.stop();
  engine_.tick(kDt);
  engine_.arm();
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(engine_.tick(kDt).force, 0.0) << "tick " << i;
    EXPECT_EQ(device_.commanded, 0.0) << "tick " << i;
  }
}

TEST_F(ForceEngineTest, StartsSoftlyInAnotherScene) {
  engine_.setScene(&scene_);
  feelAt(6.0);
  CompiledScene other(finiteElements());
  engine_.setScene(&other);
  const double before = device_.commanded;
  const auto first = engine_.tick(kDt);
  EXPECT_LT(first.force, before);
  EXPECT_TRUE((first.marks & TickSample::SoftStart) != 0);
  EXPECT_EQ(stayAt(6.0, 200).force, 0.0);
  EXPECT_NEAR(feelAt(5.0), 1.714, 5e-4);
}

TEST_F(ForceEngineTest, FadesWhileTheSwitchIsReleased) {
  engine_.setScene(&scene_);
  feelAt(6.0);
  device_.sample.isDeadManHeld = false;
  const auto fading = stayAt(6.0, 50);
  EXPECT_NEAR(fading.force, 0.5 * 3.428, 0.05);
  EXPECT_TRUE((fading.marks & TickSample::DeadManReleased) != 0);
  EXPECT_EQ(stayAt(6.0, 60).force, 0.0);
  device_.sample.isDeadManHeld = true;
  EXPECT_EQ(stayAt(6.0, 100).force, 0.0);  // and comes back softly
  EXPECT_NEAR(feelAt(5.0), 1.714, 5e-4);
}

TEST_F(ForceEngineTest, FadesIfTheToolIsTooFast) {
  ForceEngine engine(device_, {.maxForce = 6.0, .maxRate = 300.0, .maxVelocity = 50.0});
  engine.setScene(&scene_);
  for (int i = 0; i < 150; ++i) engine.tick(kDt);
  device_.sample.travel = 5.0;
  for (int i = 0; i < 50; ++i) engine.tick(kDt);
  for (const double velocity : {51.0, -51.0, 1e300}) {
    device_.sample.velocity = velocity;
    EXPECT_TRUE((engine.tick(kDt).marks & TickSample::TooFast) != 0) << velocity;
  }
  for (int i = 0; i < 100; ++i) engine.tick(kDt);
  EXPECT_EQ(device_.commanded, 0.0);
}

TEST_F(ForceEngineTest, FadesIfMoreThanOnePeriodIsMissed) {
  engine_.setScene(&scene_);
  const double full = feelAt(5.0);
  EXPECT_EQ(engine_.tick(kDt, 1).force, full);  // one missed period is bridged
  const auto sample = engine_.tick(kDt, 21);    // twenty more should have faded it by a fifth
  EXPECT_NEAR(sample.force, 0.81 * full, 0.32);
  EXPECT_LT(sample.force, full);
  EXPECT_TRUE((sample.marks & TickSample::MissedPeriods) != 0);
  stayAt(5.0, 30);
  EXPECT_EQ(engine_.tick(kDt).force, full);  // and it is back
}

TEST_F(ForceEngineTest, WatchesTheEnergyOfASceneThatGivesMoreThanItGets) {
  // A wall that is felt on the way out only: every contact gives what it never took.
  engine_.setScene(&scene_);
  stayAt(0.0, 150);
  double energy = 0.0;
  bool wasActive = false;
  for (int cycle = 0; cycle < 3; ++cycle) {
    device_.sample.travel = 8.0;  // at once: the force comes after the way in
    for (double travel = 8.0; travel > 0.0; travel -= 0.05) {
      device_.sample.travel = travel;
      const auto sample = engine_.tick(kDt);
      energy = std::min(energy, sample.energy);
      wasActive = wasActive || (sample.interventions & ForceLimiter::Active) != 0;
    }
  }
  EXPECT_LT(energy, -5.0);  // about half of 7 N over 4 units
  EXPECT_TRUE(wasActive);
}

TEST_F(ForceEngineTest, DampsAnActiveSceneOnRequest) {
  const auto given = [&](bool isControlled) {
    ForceEngine engine(
        device_, {.maxForce = 9.0, .maxRate = 1e6, .isPassivityControlled = isControlled});
    engine.setScene(&scene_);
    device_.sample = {.status = devices::DeviceStatus::Ok};
    for (int i = 0; i < 150; ++i) engine.tick(kDt);
    double least = 0.0;
    for (double travel = 8.0; travel > 0.0; travel -= 0.02) {
      device_.sample.travel = travel;
      device_.sample.velocity = -20.0;
      least = std::min(least, engine.tick(kDt).energy);
    }
    return least;
  };
  EXPECT_LT(given(false), -2.0);
  EXPECT_GT(given(true), 0.8 * given(false));  // bounded damping takes up some of it
  EXPECT_GT(given(true), given(false) + 1.0);
}

TEST(SafetyLimits, AreRefusedIfTheyAreInvalid) {
  HeldDevice device;
  for (const SafetyLimits& limits :
       {SafetyLimits{.maxForce = 0.0},
        SafetyLimits{.maxRate = -1.0},
        SafetyLimits{.maxVelocity = 0.0},
        SafetyLimits{.rampTime = 0.0},
        SafetyLimits{.softStartShare = 0.0},
        SafetyLimits{.softStartShare = 1.5},
        SafetyLimits{.longestSilence = -1.0},
        SafetyLimits{.maxForce = std::nan("")}}) {
    EXPECT_THROW(ForceEngine(device, limits), std::invalid_argument);
  }
}

TEST_F(ForceEngineTest, StopsIfTheDeviceFailsAndStaysStopped) {
  engine_.setScene(&scene_);
  feelAt(6.0);
  device_.sample.status = devices::DeviceStatus::NotAnswering;
  const auto gone = engine_.tick(kDt);
  EXPECT_EQ(gone.force, 0.0);
  EXPECT_TRUE((gone.marks & TickSample::Invalid) != 0);
  EXPECT_EQ(gone.travel, 6.0);  // the last one, marked; not a plausible zero
  device_.sample.status = devices::DeviceStatus::Ok;
  EXPECT_EQ(engine_.tick(kDt).force, 0.0);
  EXPECT_TRUE(engine_.isStopped());
}

TEST_F(ForceEngineTest, StopsIfTheDeviceReportsAFault) {
  engine_.setScene(&scene_);
  ASSERT_GT(feelAt(6.0), 3.0);
  device_.sample.status = devices::DeviceStatus::Faulted;
  const auto faulted = engine_.tick(kDt);
  EXPECT_EQ(faulted.force, 0.0);
  EXPECT_EQ(device_.commanded, 0.0);
  EXPECT_EQ(faulted.status, devices::DeviceStatus::Faulted);
  EXPECT_TRUE((faulted.marks & TickSample::Stopped) != 0);
  EXPECT_TRUE(engine_.isStopped());
  device_.sample.status = devices::DeviceStatus::Ok;
  EXPECT_EQ(stayAt(0.0, 200).force, 0.0) << "until the operator has decided";
  EXPECT_EQ(stayAt(6.0, 200).force, 0.0);
}

TEST_F(ForceEngineTest, BridgesOneMissingSampleAndThenFades) {
  engine_.setScene(&scene_);
  const double full = feelAt(5.0);
  device_.sample.status = devices::DeviceStatus::Stale;
  EXPECT_EQ(engine_.tick(kDt).force, full);
  device_.sample.status = devices::DeviceStatus::Ok;
  EXPECT_EQ(engine_.tick(kDt).force, full);  // nobody has noticed
  device_.sample.status = devices::DeviceStatus::Stale;
  engine_.tick(kDt);
  EXPECT_NEAR(stayAt(5.0, 50).force, 0.5 * full, 0.02 * full);
  EXPECT_FALSE(engine_.isStopped());
  stayAt(5.0, 60);  // more than a tenth of a second of silence
  EXPECT_EQ(device_.commanded, 0.0);
  EXPECT_TRUE(engine_.isStopped());
  device_.sample.status = devices::DeviceStatus::Ok;
  EXPECT_EQ(stayAt(0.0, 200).force, 0.0);  // until the operator has decided
}

TEST_F(ForceEngineTest, FadesFromTheSecondMissingSampleOn) {
  engine_.setScene(&scene_);
  const double full = feelAt(5.0);
  device_.sample.status = devices::DeviceStatus::Stale;
  EXPECT_EQ(engine_.tick(kDt).force, full);
  for (int missing = 2; missing <= 10; ++missing) {
    // A hundredth less with each: the force fades over a tenth of a second.
    EXPECT_NEAR(engine_.tick(kDt).force, full * (1.0 - 0.01 * (missing - 1)), 1e-9) << missing;
  }
}

TEST_F(ForceEngineTest, NeverCommandsNaN) {
  engine_.setScene(&scene_);
  for (const double bad : {std::nan(""), double{INFINITY}, -double{INFINITY}, 1e308, -1e308}) {
    device_.sample.travel = bad;
    engine_.tick(kDt);
    EXPECT_TRUE(std::isfinite(device_.commanded)) << bad;
    EXPECT_LE(std::abs(device_.commanded), 6.0) << bad;
  }
}

TEST_F(ForceEngineTest, RendersAgainAfterAnImpossibleJump) {
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

TEST_F(ForceEngineTest, AllocatesNothingInATickOfAnyScene) {
  CompiledScene interpolation({.model = InterpolationSpec{.curve = {{3.0, 0.0}, {7.0, 4.0}}}});
  KalmanSpec both;
  both.interpolation.curve = {{3.0, 0.0}, {7.0, 4.0}, {9.0, 2.0}};
  CompiledScene kalman({.model = both, .isVisualised = true});
  CompiledScene material({.model = MaterialSpec{.nodes = parametricMaterial()}});
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

TEST_F(ForceEngineTest, CountsEachCutOnceAndFromZeroForEachScene) {
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
  devices::SimulatedDevice device(devices::punchKind(), hand);
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
  devices::SimulatedDevice device(devices::reamerKind(), hand);
  ForceEngine engine(device, {.maxForce = 140.0, .maxRate = 5000.0});
  MaterialSpec bone{.nodes = parametricMaterial(), .hardness = 0.5, .forceScale = 0.15};
  CompiledScene scene({.model = bone});
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

}  // namespace force_engine_test
}  // namespace haptics::engine
