#include "haptics/emulators/iiwa_arm.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tests/haptics/emulators/arm_steps.h"
#include "tests/support/long_form.h"

namespace haptics::emulators {
namespace iiwa_arm_test {

using devices::JointVector;
using devices::Wrench;

/// Joints without damping of their own, so that what damps is the law.
IiwaArm anUndampedArm() {
  return armOverTheTable({.damping = JointVector::Zero()});
}

CartesianImpedance firmAcross() {
  CartesianImpedance law;
  law.stiffness << 5000.0, 5000.0, 0.0, 300.0, 300.0, 300.0;
  return law;
}

TEST(IiwaArm, StaysAtRestWithoutAPush) {
  IiwaArm arm = armOverTheTable();
  run(arm, 1.0);
  EXPECT_EQ(arm.position(), overTheTable());
  arm.setControl(CartesianImpedance{});
  run(arm, 1.0);
  EXPECT_EQ(arm.position(), overTheTable());
  EXPECT_EQ(arm.energy(), 0.0);
}

TEST(IiwaArm, AcceleratesAlongTheFreeAxisUntilDampingHoldsTheForce) {
  IiwaArm arm = anUndampedArm();
  CartesianImpedance law = firmAcross();
  law.damping[2] = 100.0;
  arm.setControl(law);
  const Eigen::Vector3d axis = arm.tool().rotation.col(2);
  arm.setExternalWrench(force(1.0 * axis));
  double speed = 0.0;
  for (int i = 0; i < 20; ++i) {
    arm.step(kDt);
    const double now = axis.dot(arm.toolTwist().head<3>());
    EXPECT_GT(now, speed);
    speed = now;
  }
  run(arm, 1.5);
  EXPECT_NEAR(axis.dot(arm.toolTwist().head<3>()), 1.0 / 100.0, 0.5e-4);  // F / b
  const Eigen::Vector3d moved =
      arm.tool().position - arm.kinematics().at(overTheTable()).tool.position;
  EXPECT_LT((moved - axis * axis.dot(moved)).norm(), 1e-5);
}

TEST(IiwaArm, BeginsWithTheInertiaOfItsJoints) {
  IiwaArm arm = anUndampedArm();
  arm.setControl(JointImpedance{.stiffness = JointVector::Zero(), .damping = JointVector::Zero()});
  const Eigen::Vector3d axis = arm.tool().rotation.col(2);
  const JointVector torque =
      arm.kinematics().at(overTheTable()).jacobian.transpose() * force(10.0 * axis);
  arm.setExternalWrench(force(10.0 * axis));
  arm.step(0.0001);
  const JointVector expected = 0.0001 * torque.cwiseQuotient(IiwaMechanics().inertia);
  EXPECT_LT((arm.velocity() - expected).norm(), 1e-12);
  EXPECT_LT((arm.externalTorque() - torque).norm(), 1e-12);
}

TEST(IiwaArm, GivesWayByForceOverStiffness) {
  IiwaArm arm = armOverTheTable({.damping = JointVector::Constant(5.0)});
  CartesianImpedance law;
  law.stiffness << 1000.0, 2000.0, 4000.0, 100.0, 200.0, 300.0;
  arm.setControl(law);
  const devices::Pose start = arm.tool();
  const Eigen::Vector3d pushed(5.0, -4.0, 8.0);  // in the axes of the tool
  arm.setExternalWrench(force(start.rotation * pushed));
  run(arm, 10.0);
  const Eigen::Vector3d moved = start.rotation.transpose() * (arm.tool().position - start.position);
  EXPECT_LT((moved - Eigen::Vector3d(0.005, -0.002, 0.002)).norm(), 1e-9);
  EXPECT_LT(devices::rotationVectorBetween(start.rotation, arm.tool().rotation).norm(), 1e-9);
}

TEST(IiwaArm, TurnsByMomentOverStiffness) {
  IiwaArm arm = armOverTheTable({.damping = JointVector::Constant(5.0)});
  CartesianImpedance law;
  law.stiffness << 2000.0, 2000.0, 2000.0, 50.0, 100.0, 200.0;
  arm.setControl(law);
  const devices::Pose start = arm.tool();
  Wrench moment = Wrench::Zero();
  moment.tail<3>() = 3.0 * start.rotation.col(0);
  arm.setExternalWrench(moment);
  run(arm, 10.0);
  const Eigen::Vector3d turned =
      devices::rotationVectorBetween(start.rotation, arm.tool().rotation);
  EXPECT_LT((turned - 3.0 / 50.0 * start.rotation.col(0)).norm(), 1e-9);
}

TEST(IiwaArm, PullsDownTheSlopeOfItsEnergy) {
  // Also where springs differ from axis to axis and the tool is turned far.
  CartesianImpedance law;
  law.stiffness << 100.0, 50.0, 20.0, 30.0, 5.0, 10.0;
  JointVector elsewhere = overTheTable();
  elsewhere += kDegree * JointVector{20.0, -10.0, 20.0, 10.0, -50.0, 40.0, 90.0};
  const auto armAt = [&](const JointVector& q) {
    IiwaArm arm(armOverTheTable().kinematics(), q);
    arm.setControl(law);
    arm.commandPosition(elsewhere);
    return arm;
  };
  constexpr double kStep = 1e-5;
  JointVector slope;
  for (Eigen::Index i = 0; i < 7; ++i) {
    const JointVector along = kStep * JointVector::Unit(i);
    slope[i] = armAt(overTheTable() + along).energy() - armAt(overTheTable() - along).energy();
  }
  IiwaArm arm = armAt(overTheTable());
  arm.step(1e-12);
  EXPECT_LT((arm.measuredTorque() + slope / (2.0 * kStep)).norm(), 1e-7);
  EXPECT_GT(
      devices::rotationVectorBetween(
          arm.tool().rotation, arm.kinematics().at(elsewhere).tool.rotation)
          .norm(),
      1.0);
}

TEST(IiwaArm, PutsItsSpringsOnTheAxesOfTheTask) {
  // The task's z is the tool's x, which is then the one that is free.
  IiwaArm arm = armOverTheTable();
  CartesianImpedance law;
  law.frame << 0.0, 0.0, 1.0,  //
      0.0, 1.0, 0.0,           //
      -1.0, 0.0, 0.0;
  arm.setControl(law);
  const devices::Pose start = arm.tool();
  arm.setExternalWrench(force(start.rotation * Eigen::Vector3d(0.2, 0.0, 4.0)));
  run(arm, 1.0);
  const Eigen::Vector3d moved = start.rotation.transpose() * (arm.tool().position - start.position);
  EXPECT_GT(moved.x(), 0.004);
  EXPECT_NEAR(moved.z(), 4.0 / 2000.0, 2e-4);
}

TEST(IiwaArm, GivesWayInItsJointsByTorqueOverStiffness) {
  IiwaArm arm = armOverTheTable();
  arm.setControl(JointImpedance{
      .stiffness = JointVector::Constant(500.0), .damping = JointVector::Constant(20.0)});
  const JointVector torque{5.0, -4.0, 3.0, 2.0, -1.0, 0.5, 0.25};
  arm.setOverlayTorque(torque);
  run(arm, 5.0);
  EXPECT_LT((arm.position() - overTheTable() - torque / 500.0).norm(), 1e-9);
  EXPECT_LT(arm.measuredTorque().norm(), 1e-6);  // law and overlay are in balance
}

/// The most energy in ten seconds after being let go, as a share of what it began with.
double mostEnergy(IiwaArm& arm, double dt, double reach = 1.0) {
  JointVector elsewhere = overTheTable();
  elsewhere += reach * kDegree * JointVector{6.0, -4.0, 5.0, 3.0, -20.0, 15.0, 30.0};
  arm.commandPosition(elsewhere);
  const double before = arm.energy();
  double most = 0.0;
  for (double t = 0.0; t < 10.0; t += dt) {
    EXPECT_TRUE(arm.step(dt));
    most = std::max(most, arm.energy());
  }
  EXPECT_GT(before, 0.01);
  return most / before;
}

TEST(IiwaArm, LosesEnergyWhenLeftAlone) {
  std::vector steps{0.001, 0.005};
  if (tests::isLong()) steps.push_back(0.0001);
  for (const double dt : steps) {
    IiwaArm springs = armOverTheTable();
    springs.setControl(firmAcross());
    EXPECT_LE(mostEnergy(springs, dt), 1.0);
    EXPECT_LT(springs.toolTwist().norm(), 1e-2);
    IiwaArm joints = armOverTheTable();
    EXPECT_LE(mostEnergy(joints, dt), 1.0);
    EXPECT_LT(joints.energy(), 1e-6);
  }
}

TEST(IiwaArm, GainsNoEnergyEvenWithoutAnyDamping) {
  // Springs that differ from axis to axis, at the coarsest step; as far as no torque is limited,
  // for a spring that is cut off is none.
  IiwaArm springs = anUndampedArm();
  CartesianImpedance law;
  law.stiffness << 5000.0, 3000.0, 1000.0, 300.0, 50.0, 120.0;
  law.dampingRatio.setZero();
  springs.setControl(law);
  EXPECT_LT(mostEnergy(springs, 0.005, 0.25), 1.02);
  EXPECT_GT(springs.energy(), 0.01);
  EXPECT_FALSE(springs.isSaturated());

  IiwaArm joints = anUndampedArm();
  joints.setControl(
      JointImpedance{.stiffness = JointVector::Constant(100.0), .damping = JointVector::Zero()});
  EXPECT_LT(mostEnergy(joints, 0.005), 1.02);
}

TEST(IiwaArm, StaysInItsLimitsWithAnyPush) {
  IiwaArm arm = armOverTheTable();
  arm.setControl(JointImpedance{.stiffness = JointVector::Zero(), .damping = JointVector::Zero()});
  const auto& limits = arm.kinematics().properties().maxPosition;
  arm.setOverlayTorque(JointVector::Constant(30.0));
  for (int i = 0; i < 3000; ++i) {
    arm.step(kDt);
    for (std::size_t j = 0; j < 7; ++j) {
      ASSERT_LE(std::abs(arm.position()[static_cast<Eigen::Index>(j)]), limits[j]);
    }
  }
  EXPECT_EQ(arm.position(), JointVector(limits.data()));
  EXPECT_EQ(arm.velocity(), JointVector::Zero());
  arm.setOverlayTorque(JointVector::Constant(-1.0));
  run(arm, 0.5);
  EXPECT_LT(arm.position()[6], limits[6]);  // free to come back
}

TEST(IiwaArm, GivesNoMoreTorqueThanItHas) {
  IiwaArm arm = armOverTheTable();
  arm.setOverlayTorque(JointVector::Constant(-1000.0));
  arm.step(kDt);
  EXPECT_TRUE(arm.isSaturated());
  const JointVector most(arm.kinematics().properties().maxTorque.data());
  EXPECT_LE((arm.measuredTorque().cwiseAbs() - most).maxCoeff(), 0.0);
}

TEST(IiwaArm, IsStableAtTheCoarsestStepAndTheStiffestSettings) {
  IiwaArm arm = armOverTheTable();
  CartesianImpedance law = firmAcross();
  law.stiffness[2] = 5000.0;
  law.dampingRatio.setOnes();
  law.damping << 1000.0, 1000.0, 1000.0, 50.0, 50.0, 50.0;
  arm.setControl(law);
  EXPECT_LE(mostEnergy(arm, 0.005), 1.0);
  IiwaArm joints = armOverTheTable();
  joints.setControl(JointImpedance{
      .stiffness = JointVector::Constant(5000.0), .damping = JointVector::Constant(400.0)});
  EXPECT_LE(mostEnergy(joints, 0.005), 1.0);
}

TEST(IiwaArm, IsStableInASingularPose) {
  IiwaArm arm(devices::IiwaKinematics(devices::IiwaModel::Iiwa7), JointVector::Zero());
  arm.setControl(firmAcross());
  arm.setExternalWrench(force({3.0, 2.0, 20.0}));
  run(arm, 5.0, 0.005);
  EXPECT_LT(arm.position().cwiseAbs().maxCoeff(), 0.3);
}

TEST(IiwaArm, IgnoresNaN) {
  IiwaArm arm = armOverTheTable();
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(arm.setOverlayWrench(Wrench::Constant(none)));
  EXPECT_FALSE(arm.setOverlayTorque(JointVector::Constant(INFINITY)));
  EXPECT_FALSE(arm.setExternalWrench(Wrench::Constant(none)));
  EXPECT_FALSE(arm.commandPosition(JointVector::Constant(none)));
  for (const double dt : {0.0, -0.001, none, 1.0}) EXPECT_FALSE(arm.step(dt));
  run(arm, 0.1);
  EXPECT_EQ(arm.position(), overTheTable());
}

TEST(IiwaArm, RefusesInvalidOptions) {
  const devices::IiwaKinematics kinematics(devices::IiwaModel::Iiwa7);
  EXPECT_THROW(IiwaArm(kinematics, JointVector::Constant(3.0)), std::invalid_argument);
  EXPECT_THROW(armOverTheTable({.inertia = JointVector::Zero()}), std::invalid_argument);
  EXPECT_THROW(armOverTheTable({.damping = JointVector::Constant(-1.0)}), std::invalid_argument);
  IiwaArm arm = armOverTheTable();
  CartesianImpedance law;
  law.stiffness[2] = -1.0;
  EXPECT_THROW(arm.setControl(law), std::invalid_argument);
  law.stiffness[2] = 5001.0;
  EXPECT_THROW(arm.setControl(law), std::invalid_argument);
  law = {};
  law.frame.setZero();
  EXPECT_THROW(arm.setControl(law), std::invalid_argument);
  EXPECT_THROW(
      arm.setControl(JointImpedance{.damping = JointVector::Constant(401.0)}),
      std::invalid_argument);
}

}  // namespace iiwa_arm_test
}  // namespace haptics::emulators
