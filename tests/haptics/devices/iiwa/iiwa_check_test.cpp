// Whether an arm over FRI can be opened, and what its check finds.
#include <future>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/haptics/devices/iiwa/emulated_arm.h"

namespace haptics::devices {
namespace iiwa_check_test {

using namespace emulated_arm;

class IiwaCheckTest : public EmulatedArm {};

TEST_F(IiwaCheckTest, NamesTheReasonWhenItCannotBeOpened) {
  const auto mine = settings();
  IiwaDevice first(mine);
  const std::int64_t begin = timing::now();
  EXPECT_TRUE(says(whyNot([&] { first.open(); }), "sends nothing to UDP port"));
  EXPECT_LT(timing::now() - begin, 4 * kSecond);
  EXPECT_EQ(first.lifecycle(), Lifecycle::Closed);
  const DatagramSocket other(Endpoint{.port = mine.port});
  EXPECT_TRUE(says(whyNot([&] { first.open(); }), "cannot be had"));
  auto odd = settings();
  odd.robot = "localhost";
  EXPECT_TRUE(says(whyNot([&] { IiwaDevice{odd}; }), "needs a numeric address"));
  odd = settings();
  odd.axis.setZero();
  EXPECT_TRUE(says(whyNot([&] { IiwaDevice{odd}; }), "an axis of reaming"));
}

TEST_F(IiwaCheckTest, DoesNotListenToAnotherAddress) {
  auto mine = settings();
  mine.robot = "127.0.0.9";
  connect(mine);
  EXPECT_TRUE(says(whyNot([&] { during([this] { device_->open(); }); }), "but 127.0.0.1 does ("));
  EXPECT_EQ(report().answers.taken, 0U);
}

TEST_F(IiwaCheckTest, PassesItsCheck) {
  connect(settings());
  std::vector<CheckResult> found;
  during([&] { found = device_->check(0.2); });
  for (const auto& line : found) {
    EXPECT_NE(line.finding, Finding::Fail)
        << base::describe(line.what) << ": " << base::describe(line.measured);
  }
  for (const char* what : {"connection", "session", "force overlay", "safety state", "joints"}) {
    ASSERT_NE(lineOf(found, what), nullptr) << what;
    EXPECT_EQ(lineOf(found, what)->finding, Finding::Pass) << what;
  }
  EXPECT_EQ(
      base::describe(lineOf(found, "session")->measured),
      "COMMANDING_ACTIVE, connection EXCELLENT");
  EXPECT_EQ(
      base::describe(lineOf(found, "messages lost, doubled, late, damaged, foreign")->measured),
      "0, 0, 0, 0, 0");
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Checked);
  during([this] { device_->arm(); });
  turns(10.0, 5);
  EXPECT_NEAR(report().force, -10.0, 1e-3);
}

TEST_F(IiwaCheckTest, FailsItsCheckInAnotherModeThanTheRobots) {
  auto mine = settings();
  const auto options = controllerFor(mine);
  mine.overlay = IiwaOverlay::JointTorque;
  auto torque = options;
  torque.arm.control = ControlMode::JointImpedance;
  torque.arm.command = ClientCommandMode::JointPosition;
  connect(mine, torque);
  std::vector<CheckResult> found;
  during([&] { found = device_->check(0.2); });
  ASSERT_NE(lineOf(found, "force overlay"), nullptr);
  EXPECT_EQ(lineOf(found, "force overlay")->finding, Finding::Fail);
  EXPECT_NE(device_->lifecycle(), Lifecycle::Checked);
}

TEST_F(IiwaCheckTest, NamesTheOverlayThatTheRobotTakes) {
  auto mine = settings();
  const auto options = controllerFor(mine);
  mine.overlay = IiwaOverlay::JointTorque;
  connect(mine, options);
  std::vector<CheckResult> found;
  during([&] { found = device_->check(0.2); });
  ASSERT_NE(lineOf(found, "force overlay"), nullptr);
  EXPECT_EQ(lineOf(found, "force overlay")->finding, Finding::Fail);
  EXPECT_TRUE(says(lineOf(found, "force overlay")->fix, R"("overlay": "wrench")"));
}

TEST_F(IiwaCheckTest, FailsItsCheckWhenMessagesStop) {
  connect(settings());
  during([&] { device_->open(); });
  const auto found = device_->check(0.2);  // and no period goes by
  ASSERT_NE(lineOf(found, "longest silence"), nullptr);
  EXPECT_EQ(lineOf(found, "longest silence")->finding, Finding::Fail);
  EXPECT_TRUE(says(lineOf(found, "longest silence")->measured, "nothing has come from the arm"));
  EXPECT_NE(device_->lifecycle(), Lifecycle::Checked);
}

TEST_F(IiwaCheckTest, FailsItsCheckAfterALongSilence) {
  connect(settings());
  during([&] { device_->open(); });
  auto checked = std::async(std::launch::async, [&] { return device_->check(1.2); });
  timing::sleepUntil(soon(700 * kMillisecond));
  std::vector<CheckResult> found;
  during([&] { found = checked.get(); });
  ASSERT_NE(lineOf(found, "longest silence"), nullptr);
  EXPECT_EQ(lineOf(found, "longest silence")->finding, Finding::Fail);
  EXPECT_TRUE(says(lineOf(found, "longest silence")->measured, "a trial ends at 40 ms"));
}

TEST_F(IiwaCheckTest, NamesAnotherSenderOnItsPort) {
  auto mine = settings();
  const auto options = controllerFor(mine);
  mine.robot = "192.0.2.147";  // an address for documentation: nobody has it
  connect(mine, options);
  const auto why = whyNot([&] { during([this] { device_->open(); }); });
  EXPECT_TRUE(says(why, "sends nothing to UDP port " + std::to_string(mine.port)));
  EXPECT_TRUE(says(why, "127.0.0.1 does ("));
  EXPECT_TRUE(says(why, R"("robot_address": "127.0.0.1")"));
}

TEST_F(IiwaCheckTest, FailsItsCheckWhereItsPortIsInUse) {
  const auto mine = settings();
  const DatagramSocket other(Endpoint{.port = mine.port});
  IiwaDevice device(mine);
  const auto found = device.check(0.1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].finding, Finding::Fail);
  EXPECT_TRUE(says(found[0].fix, "cannot be had"));
}

}  // namespace iiwa_check_test
}  // namespace haptics::devices
