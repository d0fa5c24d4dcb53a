#pragma once

#include <cmath>

#include <gtest/gtest.h>

#include "haptics/emulators/iiwa_arm.h"

/// What the tests of an arm and of a hand at it do.
namespace haptics::emulators {

constexpr double kDt = 0.001;  ///< [s]
constexpr double kDegree = 3.14159265358979323846 / 180.0;

/// Joints with the tool straight down [rad].
inline devices::JointVector overTheTable() {
  return kDegree * devices::JointVector{0.0, 30.0, 0.0, -90.0, 0.0, 60.0, 0.0};
}

/// The tool straight down, and a reamer of 0.2 m on the flange.
inline IiwaArm armOverTheTable(const IiwaMechanics& mechanics = {}) {
  const devices::Pose reamer{.position = {0.0, 0.0, 0.2}};
  return {devices::IiwaKinematics(devices::IiwaModel::Iiwa14, reamer), overTheTable(), mechanics};
}

inline devices::Wrench force(const Eigen::Vector3d& newtons) {
  devices::Wrench wrench = devices::Wrench::Zero();
  wrench.head<3>() = newtons;
  return wrench;
}

inline void run(IiwaArm& arm, double seconds, double dt = kDt) {
  const auto steps = std::lround(seconds / dt);
  for (long i = 0; i < steps; ++i) ASSERT_TRUE(arm.step(dt));
}

}  // namespace haptics::emulators
