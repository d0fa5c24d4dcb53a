#include "haptics/devices/iiwa/iiwa_kinematics.h"

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/support/allocation_counter.h"

namespace haptics::devices {
namespace iiwa_kinematics_test {

constexpr double kQuarter = 1.57079632679489661923;
constexpr IiwaModel kModels[] = {IiwaModel::Iiwa7, IiwaModel::Iiwa14};

Pose aTool() {
  return {
      .position = {0.01, -0.02, 0.18},
      .rotation =
          Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix()};
}

JointVector anyJoints(std::mt19937_64& random, const IiwaProperties& arm) {
  JointVector q;
  for (Eigen::Index i = 0; i < 7; ++i) {
    const double most = arm.maxPosition[static_cast<std::size_t>(i)];
    q[i] = std::uniform_real_distribution(-most, most)(random);
  }
  return q;
}

/// The flange by the product of exponentials: turns about seven axes that stand where they stand
/// while the arm is straight up, A7 first.
Pose flangeByScrews(const IiwaProperties& arm, const JointVector& q) {
  const double shoulder = arm.baseToShoulder;
  const double elbow = shoulder + arm.shoulderToElbow;
  const double wrist = elbow + arm.elbowToWrist;
  const double heights[] = {0.0, shoulder, 0.0, elbow, 0.0, wrist, 0.0};
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d axes[] = {up, y, up, -y, up, y, up};
  Pose pose{.position = (wrist + arm.wristToFlange) * up};
  for (int i = 6; i >= 0; --i) {
    const Eigen::AngleAxisd turn(q[i], axes[i]);
    const Eigen::Vector3d centre = heights[i] * up;
    pose.position = centre + turn * (pose.position - centre);
    pose.rotation = turn * pose.rotation;
  }
  return pose;
}

/// @p joint (from 1) at @p angle and all others at zero.
JointVector only(int joint, double angle) {
  JointVector q = JointVector::Zero();
  q[joint - 1] = angle;
  return q;
}

double errorOf(const Pose& pose, const Eigen::Vector3d& position) {
  return (pose.position - position).norm();
}

TEST(IiwaModel, ReachesTheDistanceInItsName) {
  // From A2 to the wrist's centre: 800 mm and 820 mm.
  const auto reach = [](IiwaModel model) {
    return propertiesOf(model).shoulderToElbow + propertiesOf(model).elbowToWrist;
  };
  EXPECT_NEAR(reach(IiwaModel::Iiwa7), 0.80, 1e-12);
  EXPECT_NEAR(reach(IiwaModel::Iiwa14), 0.82, 1e-12);
}

TEST(IiwaModel, GivesLimitsInRadians) {
  EXPECT_NEAR(propertiesOf(IiwaModel::Iiwa7).maxPosition[6], 175.0 / 90.0 * kQuarter, 1e-12);
  EXPECT_NEAR(propertiesOf(IiwaModel::Iiwa14).maxVelocity[3], 75.0 / 90.0 * kQuarter, 1e-12);
  EXPECT_EQ(propertiesOf(IiwaModel::Iiwa14).maxTorque[0], 320.0);
}

TEST(IiwaKinematics, StandsStraightUpAtZero) {
  const Pose small = IiwaKinematics(IiwaModel::Iiwa7).at(JointVector::Zero()).tool;
  const Pose large = IiwaKinematics(IiwaModel::Iiwa14).at(JointVector::Zero()).tool;
  EXPECT_LT(errorOf(small, {0.0, 0.0, 1.266}), 1e-15);
  EXPECT_LT(errorOf(large, {0.0, 0.0, 1.306}), 1e-15);
  EXPECT_TRUE(large.rotation.isIdentity(1e-15));
}

TEST(IiwaKinematics, BendsWhereTheArmBends) {
  const IiwaKinematics arm(IiwaModel::Iiwa7);
  EXPECT_LT(errorOf(arm.at(only(2, kQuarter)).tool, {0.926, 0.0, 0.34}), 1e-15);
  EXPECT_LT(errorOf(arm.at(only(4, kQuarter)).tool, {-0.526, 0.0, 0.74}), 1e-15);
  EXPECT_LT(errorOf(arm.at(only(6, kQuarter)).tool, {0.126, 0.0, 1.14}), 1e-15);
  JointVector q = only(2, kQuarter);
  q[3] = kQuarter;
  EXPECT_LT(errorOf(arm.at(q).tool, {0.4, 0.0, 0.866}), 1e-15);
  q = only(2, kQuarter);
  q[0] = kQuarter;
  EXPECT_LT(errorOf(arm.at(q).tool, {0.0, 0.926, 0.34}), 1e-15);
}

TEST(IiwaKinematics, PointsTheToolStraightDownAsASurgeonWould) {
  const IiwaKinematics arm(IiwaModel::Iiwa14);
  JointVector q = JointVector::Zero();
  q[1] = kQuarter / 3.0;
  q[3] = -kQuarter;
  q[5] = 2.0 * kQuarter / 3.0;
  EXPECT_TRUE(arm.at(q).tool.rotation.col(2).isApprox(-Eigen::Vector3d::UnitZ(), 1e-14));
}

TEST(IiwaKinematics, AgreesWithTheProductOfExponentials) {
  std::mt19937_64 random(1);
  for (const IiwaModel model : kModels) {
    const IiwaKinematics arm(model);
    for (int i = 0; i < 1000; ++i) {
      const JointVector q = anyJoints(random, arm.properties());
      const Pose expected = flangeByScrews(arm.properties(), q);
      EXPECT_LT(errorOf(arm.at(q).tool, expected.position), 1e-14);
      EXPECT_LT((arm.at(q).tool.rotation - expected.rotation).norm(), 1e-14);
    }
  }
}

TEST(IiwaKinematics, PutsTheToolOnTheFlange) {
  std::mt19937_64 random(2);
  const IiwaKinematics arm(IiwaModel::Iiwa7, aTool());
  for (int i = 0; i < 100; ++i) {
    const JointVector q = anyJoints(random, arm.properties());
    const Pose flange = flangeByScrews(arm.properties(), q);
    const Eigen::Vector3d expected = flange.position + flange.rotation * aTool().position;
    EXPECT_LT(errorOf(arm.at(q).tool, expected), 1e-14);
    EXPECT_LT((arm.at(q).tool.rotation - flange.rotation * aTool().rotation).norm(), 1e-14);
  }
}

TEST(IiwaKinematics, KeepsRotationsOrthonormal) {
  std::mt19937_64 random(3);
  const IiwaKinematics arm(IiwaModel::Iiwa14, aTool());
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Matrix3d r = arm.at(anyJoints(random, arm.properties())).tool.rotation;
    EXPECT_LT((r * r.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_NEAR(r.determinant(), 1.0, 1e-14);
  }
}

/// The Jacobian by differences of the screws' tool, not of our own.
IiwaJacobian jacobianByDifferences(const IiwaProperties& arm, const JointVector& q) {
  constexpr double kStep = 1e-6;
  IiwaJacobian jacobian;
  for (int i = 0; i < 7; ++i) {
    const Pose ahead = flangeByScrews(arm, q + only(i + 1, kStep)) * aTool();
    const Pose behind = flangeByScrews(arm, q - only(i + 1, kStep)) * aTool();
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(ahead.rotation * behind.rotation.transpose()));
    jacobian.col(i).head<3>() = (ahead.position - behind.position) / (2.0 * kStep);
    jacobian.col(i).tail<3>() = turn.angle() * turn.axis() / (2.0 * kStep);
  }
  return jacobian;
}

TEST(IiwaKinematics, HasTheJacobianOfItsOwnMotion) {
  std::mt19937_64 random(4);
  for (const IiwaModel model : kModels) {
    const IiwaKinematics arm(model, aTool());
    for (int i = 0; i < 200; ++i) {
      const JointVector q = anyJoints(random, arm.properties());
      const IiwaJacobian expected = jacobianByDifferences(arm.properties(), q);
      EXPECT_LT((arm.at(q).jacobian - expected).cwiseAbs().maxCoeff(), 1e-8);
    }
  }
}

TEST(IiwaKinematics, HoldsAWeightOnAStretchedArmByItsLever) {
  // 10 N down at 0.926 m from A2, 0.526 m from A4 and 0.126 m from A6; A4 turns the other way.
  const IiwaKinematics arm(IiwaModel::Iiwa7);
  Wrench down = Wrench::Zero();
  down[2] = -10.0;
  const JointVector torque = arm.at(only(2, kQuarter)).jacobian.transpose() * down;
  JointVector expected;
  expected << 0.0, 9.26, 0.0, -5.26, 0.0, 1.26, 0.0;
  EXPECT_LT((torque - expected).norm(), 1e-13);
}

TEST(IiwaKinematics, MeasuresTravelAlongAnAxis) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1.0, 2.0, 2.0) / 3.0;
  const Pose start{.position = {0.1, 0.2, 0.3}};
  const Eigen::Vector3d across = axis.cross(Eigen::Vector3d::UnitX());
  const Pose now{.position = start.position + 0.012 * axis + 0.5 * across};
  EXPECT_NEAR(displacementAlong(axis, start, now), 0.012, 1e-15);
  EXPECT_NEAR(displacementAlong(axis, now, start), -0.012, 1e-15);
}

TEST(IiwaKinematics, KnowsTheTurnFromOneOrientationToAnother) {
  std::mt19937_64 random(6);
  const IiwaKinematics arm(IiwaModel::Iiwa7);
  for (const double angle : {0.0, 1e-12, 1e-6, 0.3, -0.3, 2.0, 3.14, -2.0, -3.14}) {
    const Eigen::Matrix3d from = arm.at(anyJoints(random, arm.properties())).tool.rotation;
    const Eigen::Vector3d turn = angle * Eigen::Vector3d(2.0, -1.0, 2.0) / 3.0;
    const Eigen::Vector3d axis = Eigen::Vector3d(2.0, -1.0, 2.0) / 3.0;
    const Eigen::Matrix3d to = Eigen::AngleAxisd(angle, axis) * from;
    EXPECT_LT((rotationVectorBetween(from, to) - turn).norm(), 1e-14) << angle;
  }
}

TEST(IiwaKinematics, RefusesAToolThatIsNone) {
  Pose sheared = aTool();
  sheared.rotation(0, 1) += 0.1;
  EXPECT_THROW(IiwaKinematics(IiwaModel::Iiwa7, sheared), std::invalid_argument);
  Pose mirrored;
  mirrored.rotation(2, 2) = -1.0;
  EXPECT_THROW(IiwaKinematics(IiwaModel::Iiwa7, mirrored), std::invalid_argument);
  Pose nowhere;
  nowhere.position[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(IiwaKinematics(IiwaModel::Iiwa7, nowhere), std::invalid_argument);
}

TEST(IiwaKinematics, AllocatesNothing) {
  const IiwaKinematics arm(IiwaModel::Iiwa7, aTool());
  const JointVector q = JointVector::Constant(0.3);
  const tests::AllocationCounter allocations;
  double sum = 0.0;
  for (int i = 0; i < 100; ++i) {
    const auto state = arm.at(q);
    sum += state.tool.position.sum() + state.jacobian.sum();
  }
  EXPECT_EQ(allocations.count(), 0U);
  EXPECT_TRUE(std::isfinite(sum));
}

}  // namespace iiwa_kinematics_test
}  // namespace haptics::devices
