#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/devices/hand.h"
#include "tests/haptics/emulators/arm_steps.h"
#include "tests/support/allocation_counter.h"

namespace haptics::emulators {
namespace surgeon_hand_test {

using devices::JointVector;
using devices::Wrench;

/// An arm that is free along its tool's z, with the tool straight down.
IiwaArm aFreeArm() {
  IiwaArm arm = armOverTheTable();
  arm.setControl(CartesianImpedance{});
  return arm;
}

/// Pushes with the same force, wherever the tool is.
class SteadyHand final : public devices::Hand {
 public:
  explicit SteadyHand(double force) : force_(force) {}
  double push(double /*travel*/, double /*velocity*/, double /*dt*/) noexcept override {
    return force_;
  }

 private:
  double force_;
};

SurgeonHand::Grip gripOf(const IiwaArm& arm) {
  return {.axis = arm.tool().rotation.col(2), .start = arm.tool()};
}

TEST(SurgeonHand, PushesAlongItsAxisAndHoldsAcrossIt) {
  SteadyHand push(7.0);
  const Eigen::Vector3d axis(0.0, 0.0, -2.0);  // any length
  SurgeonHand hand({.axis = axis, .lateralStiffness = 500.0, .lateralDamping = 20.0}, push);
  const devices::Pose tool{.position = {0.01, 0.0, -0.03}};
  devices::Twist twist = devices::Twist::Zero();
  twist.head<3>() << 0.0, 0.1, -0.5;
  const Wrench wrench = hand.wrench(tool, twist, kDt);
  EXPECT_LT((wrench - force({-5.0, -2.0, -7.0})).norm(), 1e-12);
  EXPECT_NEAR(hand.travel(tool), 0.03, 1e-15);
}

TEST(SurgeonHand, TurnsTheToolBack) {
  SteadyHand push(0.0);
  SurgeonHand hand({.rotationalStiffness = 10.0, .rotationalDamping = 0.3}, push);
  devices::Pose tool;
  tool.rotation << 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0;  // a quarter about z
  devices::Twist twist = devices::Twist::Zero();
  twist[3] = 2.0;
  const Wrench wrench = hand.wrench(tool, twist, kDt);
  EXPECT_NEAR(wrench[3], -0.6, 1e-12);
  EXPECT_NEAR(wrench[5], -10.0 * 90.0 * kDegree, 1e-12);
  EXPECT_THROW(SurgeonHand({.axis = Eigen::Vector3d::Zero()}, push), std::invalid_argument);
  EXPECT_THROW(SurgeonHand({.rotationalDamping = -1.0}, push), std::invalid_argument);
}

TEST(SurgeonHand, BalancesAHandByAnEqualAndOppositeWrench) {
  IiwaArm arm = aFreeArm();
  SteadyHand push(40.0);
  SurgeonHand hand(gripOf(arm), push);
  arm.setHand(&hand);
  arm.setOverlayWrench(force(-40.0 * hand.grip().axis));
  run(arm, 2.0);
  EXPECT_LT((arm.tool().position - hand.grip().start.position).norm(), 1e-9);
  EXPECT_LT((arm.measuredTorque() + arm.externalTorque()).norm(), 1e-6);
  arm.setOverlayWrench(Wrench::Zero());
  run(arm, 0.1);
  EXPECT_GT(hand.travel(arm.tool()), 0.005);
}

/// Where the tool is along its axis each 5 ms while a person advances it by 20 mm and comes back.
std::vector<double> pathOfAPerson(double dt) {
  devices::SimulatedHand person(
      {.closed = 0.02, .pauseTime = 0.1, .stiffness = 1000.0, .damping = 60.0});
  IiwaArm arm = aFreeArm();
  SurgeonHand hand(gripOf(arm), person);
  arm.setHand(&hand);
  std::vector<double> path;
  for (int i = 0; i < 240; ++i) {
    run(arm, 0.005, dt);
    path.push_back(hand.travel(arm.tool()));
  }
  return path;
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

TEST(SurgeonHand, MovesAnArmTheSameWithAnyStep) {
  const std::vector<double> path = pathOfAPerson(0.001);
  EXPECT_GT(*std::max_element(path.begin(), path.end()), 0.018);
  EXPECT_LT(largestDifference(path, pathOfAPerson(0.0005)), 1e-12);  // steps of its own are equal
  EXPECT_LT(largestDifference(path, pathOfAPerson(0.005)), 1e-12);
  EXPECT_LT(largestDifference(path, pathOfAPerson(0.0001)), 2e-5);
}

TEST(SurgeonHand, AllocatesNothingOnAnArm) {
  IiwaArm arm = aFreeArm();
  SteadyHand push(5.0);
  SurgeonHand hand(gripOf(arm), push);
  arm.setHand(&hand);
  const tests::AllocationCounter allocations;
  for (int i = 0; i < 100; ++i) {
    arm.setOverlayWrench(Wrench::Zero());
    arm.commandPosition(arm.position());
    arm.step(kDt);
  }
  EXPECT_EQ(allocations.count(), 0U);
}

TEST(SurgeonHand, LeavesAnArmFiniteIfItsForceIsNaN) {
  IiwaArm arm = aFreeArm();
  SteadyHand push(std::numeric_limits<double>::quiet_NaN());
  SurgeonHand hand(gripOf(arm), push);
  arm.setHand(&hand);
  EXPECT_FALSE(arm.step(kDt));
  EXPECT_TRUE(arm.measuredTorque().allFinite());
  EXPECT_TRUE(arm.externalTorque().allFinite());
  arm.setHand(nullptr);
  run(arm, 0.1);
  EXPECT_EQ(arm.position(), arm.commandedPosition());
}

}  // namespace surgeon_hand_test
}  // namespace haptics::emulators
