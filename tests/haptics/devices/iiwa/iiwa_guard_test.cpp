#include "haptics/devices/iiwa/iiwa_guard.h"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace haptics::devices {
namespace iiwa_guard_test {

constexpr IiwaGuard::Margins kMargins{.position = 0.1, .velocity = 0.5, .torque = 0.25};
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kEndless = std::numeric_limits<double>::infinity();
const JointVector kNothing = JointVector::Zero();

JointVector only(Eigen::Index joint, double value) {
  JointVector vector = JointVector::Zero();
  vector[joint] = value;
  return vector;
}

std::string words(DeviceFault fault) {
  return base::describe(fault.of("arm"));
}

class IiwaGuardTest : public testing::TestWithParam<IiwaModel> {
 protected:
  const IiwaProperties& arm_ = propertiesOf(GetParam());
  const IiwaGuard guard_{GetParam(), kMargins};
};

INSTANTIATE_TEST_SUITE_P(
    Models,
    IiwaGuardTest,
    testing::Values(IiwaModel::Iiwa7, IiwaModel::Iiwa14),
    [](const auto& model) {
      return std::string(model.param == IiwaModel::Iiwa7 ? "Iiwa7" : "Iiwa14");
    });

TEST_P(IiwaGuardTest, FindsNothingWrongWithAnArmThatRests) {
  EXPECT_FALSE(guard_.reasonNotToCommand(kNothing, kNothing, kNothing));
}

TEST_P(IiwaGuardTest, KeepsEveryJointAwayFromItsEnds) {
  for (Eigen::Index i = 0; i < 7; ++i) {
    const double most = arm_.maxPosition[static_cast<std::size_t>(i)] - kMargins.position;
    const auto wrongAt = [&](double position) {
      return words(guard_.reasonNotToCommand(only(i, position), kNothing, kNothing));
    };
    const std::string near = "arm: joint A" + std::to_string(i + 1) + " is near its end";
    for (const double side : {1.0, -1.0}) {
      EXPECT_EQ(wrongAt(side * (most - 1e-9)), "");
      EXPECT_EQ(wrongAt(side * (most + 1e-9)), near);
      EXPECT_EQ(wrongAt(side * kEndless), near);
    }
    EXPECT_EQ(wrongAt(kNotANumber), near);
  }
}

TEST_P(IiwaGuardTest, AllowsEveryJointAShareOfItsSpeed) {
  for (Eigen::Index i = 0; i < 7; ++i) {
    const double most = arm_.maxVelocity[static_cast<std::size_t>(i)] * kMargins.velocity;
    const auto wrongAt = [&](double velocity) {
      return words(guard_.reasonNotToCommand(kNothing, only(i, velocity), kNothing));
    };
    const std::string fast = "arm: joint A" + std::to_string(i + 1) + " is too fast";
    for (const double side : {1.0, -1.0}) {
      EXPECT_EQ(wrongAt(side * (most - 1e-9)), "");
      EXPECT_EQ(wrongAt(side * (most + 1e-9)), fast);
    }
    EXPECT_EQ(wrongAt(kNotANumber), fast);
  }
}

TEST_P(IiwaGuardTest, AllowsEveryJointItsTorque) {
  for (Eigen::Index i = 0; i < 7; ++i) {
    const double most = arm_.maxTorque[static_cast<std::size_t>(i)];
    const auto wrongAt = [&](double torque) {
      return words(guard_.reasonNotToCommand(kNothing, kNothing, only(i, torque)));
    };
    const std::string overloaded = "arm: joint A" + std::to_string(i + 1) + " is overloaded";
    for (const double side : {1.0, -1.0}) {
      EXPECT_EQ(wrongAt(side * most), "");
      EXPECT_EQ(wrongAt(side * (most + 1e-9)), overloaded);
    }
    EXPECT_EQ(wrongAt(kNotANumber), overloaded);
  }
}

TEST_P(IiwaGuardTest, AllowsAnOverlayItsShareOfTheTorque) {
  for (Eigen::Index i = 0; i < 7; ++i) {
    const double most = arm_.maxTorque[static_cast<std::size_t>(i)] * kMargins.torque;
    for (const double side : {1.0, -1.0}) {
      EXPECT_EQ(guard_.allowedFactor(only(i, side * most)), 1.0);
      EXPECT_DOUBLE_EQ(guard_.allowedFactor(only(i, side * 4.0 * most)), 0.25);
    }
  }
  EXPECT_EQ(guard_.allowedFactor(kNothing), 1.0);
}

TEST_P(IiwaGuardTest, LetsTheJointThatHasLeastDecide) {
  JointVector most;
  for (Eigen::Index i = 0; i < 7; ++i) {
    most[i] = arm_.maxTorque[static_cast<std::size_t>(i)] * kMargins.torque;
  }
  for (const auto& [worst, other] : {std::pair{5, 2}, {2, 5}}) {
    auto torque = most;
    torque[worst] *= -8.0;
    torque[other] *= 2.0;
    EXPECT_DOUBLE_EQ(guard_.allowedFactor(torque), 0.125) << worst;
  }
}

TEST_P(IiwaGuardTest, AllowsNothingOfWhatIsNotFinite) {
  for (Eigen::Index i = 0; i < 7; ++i) {
    for (const double bad : {kNotANumber, kEndless, -kEndless}) {
      EXPECT_EQ(guard_.allowedFactor(only(i, bad)), 0.0);
    }
  }
}

}  // namespace iiwa_guard_test
}  // namespace haptics::devices
