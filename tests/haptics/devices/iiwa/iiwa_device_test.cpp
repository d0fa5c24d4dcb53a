// An arm over FRI in a session: what it feels, and what it is made to push with.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/haptics/devices/iiwa/emulated_arm.h"
#include "tests/support/allocation_counter.h"

namespace haptics::devices {
namespace iiwa_device_test {

using namespace emulated_arm;

class IiwaDeviceTest : public EmulatedArm {};

class IiwaSessionTest : public EmulatedArm, public testing::WithParamInterface<Session> {};

INSTANTIATE_TEST_SUITE_P(
    Sessions,
    IiwaSessionTest,
    testing::Values(
        Session{Version::V1_11, IiwaOverlay::CartesianWrench},
        Session{Version::V1_15, IiwaOverlay::CartesianWrench},
        Session{Version::V1_15, IiwaOverlay::JointTorque},
        Session{Version::V2_5, IiwaOverlay::CartesianWrench},
        Session{Version::V2_7, IiwaOverlay::CartesianWrench},
        Session{Version::V2_7, IiwaOverlay::JointTorque}),
    [](const auto& session) {
      std::string name = "Fri" + std::string(nameOf(session.param.version));
      std::replace(name.begin(), name.end(), '.', '_');
      return name + (session.param.overlay == IiwaOverlay::JointTorque ? "Torque" : "Wrench");
    });

TEST_P(IiwaSessionTest, ReachesCommandingAndGivesForceAgainstAdvancing) {
  connect(settings(GetParam().version, GetParam().overlay));
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Closed);
  during([this] { device_->open(); });
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Open);
  during([this] { device_->arm(); });
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Armed);
  EXPECT_EQ(report().state, SessionState::CommandingActive);
  for (const double force : {10.0, -4.0, 25.0}) {
    turns(force, 50);
    ASSERT_FALSE(isFaulted()) << base::describe(device_->fault());
    EXPECT_NEAR(report().force, -force, 0.05);
  }
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Running);
  turns(0.0, 2);
  EXPECT_EQ(report().force, 0.0);
  EXPECT_EQ(report().lastEnd, emulators::FriEndReason::None);
  EXPECT_LT(turn(0.0).travel, 0.0);  // and has been pushed back by it
}

TEST_P(IiwaSessionTest, GivesATorqueAboutTheAxisAndTurnsByIt) {
  connect(settings(GetParam().version, GetParam().overlay));
  openAndArm();
  for (const double torque : {2.0, -1.5}) {
    turns(5.0, 100, torque);
    ASSERT_FALSE(isFaulted()) << base::describe(device_->fault());
    EXPECT_NEAR(report().torque, torque, 0.01);
    EXPECT_NEAR(report().force, -5.0, 0.05);
    const auto sample = turn(5.0, torque);
    EXPECT_GT(sample.turn * torque, 0.0) << "the arm turns the way that it is pushed";
    EXPECT_NEAR(sample.turn, report().turn, 0.01);
  }
  turns(0.0, 2);
  EXPECT_EQ(report().torque, 0.0);
}

TEST_P(IiwaSessionTest, ComputesTheTravelOfTheController) {
  const auto mine = settings(GetParam().version, GetParam().overlay);
  auto options = controllerFor(mine);
  options.arm.person = {
      .closed = 0.03,
      .pauseTime = 0.0,
      .closeTime = 0.4,
      .openTime = 0.3,
      .stiffness = 2000.0,
      .damping = 60.0};
  connect(mine, options);
  openAndArm();
  double most = 0.0;
  for (int i = 0; i < 300; ++i) {
    const double travel = report().travel;  // of which the next message tells
    const auto sample = turn(5.0);
    ASSERT_EQ(sample.status, DeviceStatus::Ok) << base::describe(device_->fault());
    ASSERT_NEAR(sample.travel, travel, 1e-6);
    most = std::max(most, sample.travel);
  }
  EXPECT_GT(most, 0.015);
}

TEST_F(IiwaDeviceTest, CountsTravelFromWhereItIsArmedByDefault) {
  auto mine = settings();
  mine.zero.reset();
  auto options = controllerFor(mine);
  options.arm.start[1] += 0.2;
  connect(mine, options);
  openAndArm();
  EXPECT_NEAR(turn(0.0).travel, 0.0, 1e-4);
}

TEST_F(IiwaDeviceTest, ConnectsToARobotAtAnyAddress) {
  auto mine = settings();
  mine.robot = "127.0.0.2";
  auto options = controllerFor(mine);
  options.local.address = endpointFrom("127.0.0.2")->address;
  connect(mine, options);
  work(10.0);
  EXPECT_FALSE(isFaulted()) << base::describe(device_->fault());
}

TEST_F(IiwaDeviceTest, AllocatesNothingInATick) {
  connect(settings());
  work(5.0);
  std::size_t count = 0;
  for (int i = 0; i < 100; ++i) {
    period();
    const tests::AllocationCounter allocations;
    answer(5.0);
    count += allocations.count();
  }
  EXPECT_EQ(count, 0U);
}

TEST_F(IiwaDeviceTest, MakesNoForceAfterItIsDisarmed) {
  connect(settings());
  work(10.0);
  device_->disarm();
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Open);
  device_->command(10.0, 0.0);
  during([] { timing::sleepUntil(soon(20 * kMillisecond)); });
  EXPECT_EQ(report().force, 0.0);
  EXPECT_EQ(report().state, SessionState::CommandingActive);
  during([this] { device_->arm(); });
  turns(10.0, 5);
  EXPECT_NEAR(report().force, -10.0, 1e-3);
}

TEST_F(IiwaDeviceTest, ClipsAForceThatItDoesNotGiveAndCountsIt) {
  auto mine = settings();
  mine.maxForce = 20.0;
  connect(mine);
  work(10.0);
  const auto before = device_->link().clipped;
  turns(30.0, 10);
  EXPECT_EQ(device_->link().clipped, before + 10);
  EXPECT_NEAR(report().force, -20.0, 1e-3);
  turns(20.0, 10);
  EXPECT_EQ(device_->link().clipped, before + 10);
  turns(std::nan(""), 2);
  EXPECT_EQ(report().force, 0.0);
  EXPECT_EQ(device_->link().clipped, before + 12);
}

TEST_F(IiwaDeviceTest, ClipsATorqueThatItDoesNotGiveAndCountsIt) {
  auto mine = settings();
  mine.maxTorque = 1.5;
  connect(mine);
  work(10.0);
  const auto before = device_->link().clipped;
  turns(10.0, 10, -4.0);
  EXPECT_EQ(device_->link().clipped, before + 10);
  EXPECT_NEAR(report().torque, -1.5, 1e-3);
  turns(10.0, 2, std::nan(""));
  EXPECT_EQ(report().torque, 0.0);
}

TEST_F(IiwaDeviceTest, SaysWhetherItRendersATorque) {
  auto mine = settings();
  EXPECT_TRUE(IiwaDevice(mine).capabilities().rendersTorque());
  mine.maxTorque = 0.0;
  EXPECT_FALSE(IiwaDevice(mine).capabilities().rendersTorque());
}

TEST_F(IiwaDeviceTest, GivesNoMoreThanTheGuardAllows) {
  auto mine = settings(Version::V1_15, IiwaOverlay::JointTorque);
  mine.margins.torque = 0.01;  // 3.2 N·m in A2
  connect(mine);
  openAndArm();
  turns(100.0, 30);
  EXPECT_LT(report().force, 0.0);
  EXPECT_GT(report().force, -15.0);
  EXPECT_GT(device_->link().clipped, 25U);
}

}  // namespace iiwa_device_test
}  // namespace haptics::devices
