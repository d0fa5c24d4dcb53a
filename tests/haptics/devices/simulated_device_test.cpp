#include "haptics/devices/simulated_device.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "haptics/devices/hand.h"
#include "haptics/devices/iiwa/reamer_kind.h"
#include "haptics/devices/punch/punch_kind.h"

namespace haptics::devices {
namespace simulated_device_test {

constexpr double kDt = 0.001;

/// A hand that pushes with one force.
class SteadyHand final : public Hand {
 public:
  explicit SteadyHand(double force) : force_(force) {}
  double push(double /*travel*/, double /*velocity*/, double /*dt*/) noexcept override {
    return force_;
  }

 private:
  double force_;
};

DeviceSample after(SimulatedDevice& device, int ticks) {
  DeviceSample sample;
  for (int i = 0; i < ticks; ++i) sample = device.read(kDt);
  return sample;
}

TEST(SimulatedDevice, ReachesTheSpeedAtWhichFrictionBalancesThePush) {
  auto capabilities = simulated(punchKind());
  capabilities.largestTravel = 1e6;
  SteadyHand hand(2.0);
  SimulatedDevice device(capabilities, {.damping = 0.1}, hand);
  EXPECT_NEAR(after(device, 2000).velocity, 2.0 / 0.1, 1e-6);
}

TEST(SimulatedDevice, StandsStillIfTheForcesAreEqual) {
  SteadyHand hand(2.0);
  SimulatedDevice device(punchKind(), hand);
  device.command(2.0, 0.0);
  EXPECT_EQ(after(device, 500).travel, 0.0);
}

TEST(SimulatedDevice, TurnsByTheTorqueUntilTheWristHoldsIt) {
  SteadyHand hand(0.0);
  SimulatedDevice reamer(reamerKind(), hand);
  reamer.command(0.0, -3.0);
  EXPECT_NEAR(after(reamer, 3000).turn, -3.0 / 10.0, 1e-6);  // torque over the wrist's stiffness
  SimulatedDevice punch(punchKind(), hand);
  punch.command(0.0, -3.0);
  EXPECT_EQ(after(punch, 100).turn, 0.0);
}

TEST(SimulatedDevice, IsHeldByTheStopAtTheEndOfItsTravel) {
  SteadyHand hand(8.0);
  SimulatedDevice device(punchKind(), hand);
  EXPECT_NEAR(after(device, 5000).travel, 11.0 + 8.0 / 80.0, 0.05);  // push over stop stiffness
}

TEST(SimulatedDevice, SeesTravelInStepsOfItsEncoder) {
  SteadyHand hand(1.0);
  SimulatedDevice device(punchKind(), hand);
  for (int i = 0; i < 300; ++i) {
    const double steps = device.read(kDt).travel / 0.0439;
    EXPECT_NEAR(steps, std::round(steps), 1e-6);
  }
}

TEST(SimulatedDevice, GivesNoMeasurementWhileItIsUnplugged) {
  SteadyHand hand(1.0);
  SimulatedDevice device(punchKind(), hand);
  EXPECT_EQ(after(device, 10).status, DeviceStatus::Ok);
  device.unplug();
  EXPECT_EQ(after(device, 1).status, DeviceStatus::NotAnswering);
  device.plugIn();
  EXPECT_EQ(after(device, 1).status, DeviceStatus::Ok);
}

TEST(SimulatedDevice, ReportsAFaultIfItBecomesTooFast) {
  SteadyHand hand(INFINITY);
  SimulatedDevice device(punchKind(), hand);
  bool wasFaulty = false;
  for (int i = 0; i < 100; ++i) {
    const auto sample = device.read(kDt);
    EXPECT_TRUE(std::isfinite(sample.travel));
    wasFaulty = wasFaulty || sample.status == DeviceStatus::Faulted;
  }
  EXPECT_TRUE(wasFaulty);
}

TEST(SimulatedDevice, RefusesAMechanismWithoutMass) {
  SteadyHand hand(0.0);
  EXPECT_THROW(SimulatedDevice(simulated(punchKind()), {.mass = 0.0}, hand), std::invalid_argument);
}

TEST(PointerHand, PushesNoHarderThanItsStrength) {
  PointerHand hand({.stiffness = 2.0, .damping = 0.0, .speed = 1e6, .strength = 5.0});
  hand.moveTo(10.0);
  EXPECT_DOUBLE_EQ(hand.push(0.0, 0.0, 0.001), 5.0);
  EXPECT_DOUBLE_EQ(hand.push(9.0, 0.0, 0.001), 2.0);
  EXPECT_DOUBLE_EQ(hand.push(20.0, 0.0, 0.001), -5.0);
}

TEST(PointerHand, FollowsThePointerNoFasterThanAHand) {
  PointerHand hand({.stiffness = 2.0, .damping = 0.0, .speed = 40.0});
  hand.moveTo(10.0);
  EXPECT_NEAR(hand.push(0.0, 0.0, kDt), 2.0 * 40.0 * kDt, 1e-12);
  for (int i = 0; i < 1000; ++i) hand.push(0.0, 0.0, kDt);
  EXPECT_NEAR(hand.push(0.0, 0.0, kDt), 2.0 * 10.0, 1e-9);
}

}  // namespace simulated_device_test
}  // namespace haptics::devices
