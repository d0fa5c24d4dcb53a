// What an arm over FRI does when messages are lost, damaged or forged, and when the robot stops.
#include <cmath>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "tests/haptics/devices/iiwa/emulated_arm.h"

namespace haptics::devices {
namespace iiwa_faults_test {

using namespace emulated_arm;

class IiwaFaultsTest : public EmulatedArm {};

constexpr int kAttempts = 3;  // where the computer may be too busy to be in time

TEST_F(IiwaFaultsTest, CountsExactlyWhatWentWrongOnTheWay) {
  connect(settings(Version::V2_7));
  work(5.0, 5);
  order("drop 3");
  order("double 4");
  order("reorder 2");
  order("delay 1 10");
  order("garbage 5");
  turns(5.0, 120);  // for more at once the controller would call the connection bad
  order("damage 3");
  order("six-joints 2");
  order("nan 2");
  order("impostor 6");
  turns(5.0, 40);
  EXPECT_FALSE(isFaulted()) << base::describe(device_->fault());
  const auto link = device_->link();
  EXPECT_EQ(link.lost, 3U + 3U + 2U + 2U);  // what cannot be read is not there
  EXPECT_EQ(link.doubled, 4U);
  EXPECT_EQ(link.late, 2U + 1U);
  EXPECT_EQ(link.damaged, 5U + 3U + 2U + 2U);
  EXPECT_EQ(link.foreign, 6U);
  EXPECT_EQ(link.restarts, 0U);
  const auto seen = report();
  EXPECT_EQ(seen.impostors, 6U);
  EXPECT_EQ(seen.impostorAnswers, 0U);  // no other sender was answered
  EXPECT_EQ(seen.sixJoints + seen.notANumber, 4U);
  EXPECT_EQ(seen.answers.doubled + seen.answers.toUnknownMessage + seen.answers.undecodable, 0U);
  EXPECT_EQ(seen.lastEnd, emulators::FriEndReason::None);
  EXPECT_NEAR(seen.force, -5.0, 1e-3);
}

TEST_F(IiwaFaultsTest, CountsGarbageWithoutAChecksumToo) {
  connect(settings(Version::V1_15));
  work(5.0, 5);
  order("garbage 50");
  turns(5.0, 60);
  EXPECT_EQ(device_->link().damaged, 50U);
  EXPECT_EQ(device_->link().lost, 0U);
  EXPECT_NEAR(report().force, -5.0, 1e-3);
}

TEST_F(IiwaFaultsTest, IgnoresMessagesOfAnImpostor) {
  connect(settings());
  during([this] { device_->open(); });  // the sender of the first message is the robot
  order("impostor 1000000");
  during([this] { device_->arm(); });
  answer(0.0);  // what was left over
  turns(5.0, 80);
  const auto seen = report();
  EXPECT_GT(seen.impostors, 100U);
  EXPECT_EQ(seen.impostorAnswers, 0U);
  EXPECT_GE(device_->link().foreign, 80U);
  EXPECT_EQ(device_->link().lost + device_->link().late, 0U);
  EXPECT_NEAR(seen.force, -5.0, 1e-3);
}

struct Spoiler {
  const char* name;
  const char* order;
  Version version;
};

class IiwaSpoiledTest : public EmulatedArm, public testing::WithParamInterface<Spoiler> {};

INSTANTIATE_TEST_SUITE_P(
    Spoilers,
    IiwaSpoiledTest,
    testing::Values(
        Spoiler{"SixJoints", "six-joints 1000000", Version::V1_15},
        Spoiler{"NotANumber", "nan 1000000", Version::V1_15},
        Spoiler{"SixJointsOf2", "six-joints 1000000", Version::V2_7},
        Spoiler{"NotANumberOf2", "nan 1000000", Version::V2_7},
        Spoiler{"WrongVersion", "wrong-version", Version::V1_15},
        Spoiler{"WrongVersionOf2", "wrong-version", Version::V2_7}),
    [](const auto& spoiler) { return std::string(spoiler.param.name); });

TEST_P(IiwaSpoiledTest, DamagedMessagesAreIgnoredAndEndAsAFaultWhereTheyLast) {
  connect(settings(GetParam().version));
  work(10.0);
  const auto before = report();
  const auto received = device_->link().received;
  order(GetParam().order);
  EXPECT_EQ(turnUntilFault(10.0).status, DeviceStatus::NotAnswering);
  const auto seen = report();
  const auto spoiled = seen.sixJoints + seen.notANumber + seen.wrongVersion;
  EXPECT_EQ(device_->link().damaged, spoiled);
  EXPECT_EQ(device_->link().received, received);
  EXPECT_LE(seen.answers.taken, before.answers.taken);
  EXPECT_TRUE(says(device_->fault(), "has missed 20 cycles"));
  for (int i = 0; i < 10; ++i) period();
  EXPECT_EQ(report().force, 0.0);
}

TEST_F(IiwaFaultsTest, NamesTheReasonWhenItRefusesAnotherVersion) {
  connect(settings(Version::V2_7));
  order("wrong-version");
  EXPECT_TRUE(says(whyNot([&] { during([this] { device_->open(); }); }), "cannot be read as FRI"));
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Closed);
}

class IiwaStallTest : public EmulatedArm, public testing::WithParamInterface<Session> {};

INSTANTIATE_TEST_SUITE_P(
    Overlays,
    IiwaStallTest,
    testing::Values(
        Session{Version::V1_15, IiwaOverlay::CartesianWrench},
        Session{Version::V1_15, IiwaOverlay::JointTorque}),
    [](const auto& session) {
      return std::string(
          session.param.overlay == IiwaOverlay::JointTorque ? "JointTorque" : "CartesianWrench");
    });

TEST_P(IiwaStallTest, EndsAsGoneAndWithoutForceAtTheControllerWithinFiftyMilliseconds) {
  const auto mine = settings(Version::V1_15, GetParam().overlay);
  auto options = controllerFor(mine);
  options.sendPeriod = 5;  // the longest that is allowed for torques
  connect(mine, options);
  work(10.0);
  order("stall 500");
  const std::int64_t begin = controllerClock();
  EXPECT_EQ(turnUntilFault(10.0).status, DeviceStatus::NotAnswering);
  EXPECT_TRUE(says(device_->fault(), "has missed 20 cycles, or been silent for 50 ms"));
  for (int i = 0; i < 10; ++i) period();
  const auto seen = report();
  EXPECT_GT(seen.stalled, 0U);
  EXPECT_EQ(seen.force, 0.0);
  EXPECT_FALSE(seen.hasOverlay);
  EXPECT_GT(seen.overlayZeroAt, begin);
  EXPECT_LE(seen.overlayZeroAt - begin, 50 * kMillisecond);
  EXPECT_EQ(turn(10.0).status, DeviceStatus::NotAnswering);
}

TEST_F(IiwaFaultsTest, BridgesAShortStall) {
  connect(settings());
  work(10.0);
  order("stall 8");
  const auto before = device_->link().stale;
  int stale = 0;
  for (int i = 0; i < 20; ++i) stale += turn(10.0).status == DeviceStatus::Stale ? 1 : 0;
  EXPECT_EQ(stale, 4);
  EXPECT_EQ(device_->link().stale, before + 4);
  EXPECT_FALSE(isFaulted()) << base::describe(device_->fault());
  EXPECT_NEAR(report().force, -10.0, 1e-3);
}

TEST_F(IiwaFaultsTest, LetsGoWhereTheConnectionIsPoor) {
  connect(settings());
  work(10.0);
  order("quality poor");
  EXPECT_NE(turn(10.0).status, DeviceStatus::Ok);
  EXPECT_EQ(report().force, 0.0);
  turnUntilFault(10.0);
  EXPECT_EQ(report().force, 0.0);
}

TEST_F(IiwaFaultsTest, EndsWithASafetyStop) {
  connect(settings());
  work(10.0);
  order("safety-stop");
  EXPECT_EQ(turn(10.0).status, DeviceStatus::Faulted);
  EXPECT_TRUE(isFaulted());
  EXPECT_TRUE(says(device_->fault(), "SmartPad")) << base::describe(device_->fault());
  EXPECT_EQ(report().force, 0.0);
}

TEST_F(IiwaFaultsTest, EndsWithARestartOfTheController) {
  connect(settings());
  work(10.0);
  order("restart");
  EXPECT_EQ(turn(10.0).status, DeviceStatus::Faulted);
  EXPECT_FALSE(device_->fault().empty());
  EXPECT_EQ(report().force, 0.0);
}

TEST_F(IiwaFaultsTest, EndsWithTheSession) {
  connect(settings());
  work(10.0);
  order("idle");
  EXPECT_EQ(turn(10.0).status, DeviceStatus::Faulted);
  EXPECT_TRUE(says(device_->fault(), "has stopped commanding"));
}

TEST_F(IiwaFaultsTest, ReconnectsAfterEveryFault) {
  connect(settings());
  for (const char* fault : {"stall 100", "restart", "wrong-version"}) {
    work(10.0);
    order(fault);
    turnUntilFault(10.0);
    EXPECT_TRUE(says(whyNot([&] { device_->arm(); }), "is not ready"));
    device_->disarm();
    if (std::string(fault) == "wrong-version") order(fault);
    for (int i = 0; i < 100; ++i) period();
  }
  work(10.0);
  EXPECT_TRUE(device_->fault().empty());
}

// In real time, with a controller that goes on by itself.

TEST_F(IiwaFaultsTest, WorksInRealTimeAndLetsGoInTime) {
  std::int64_t after = 0;
  bool hasPushed = false;
  for (int i = 0; i < kAttempts && !(after > 0 && after <= 50 * kMillisecond); ++i) {
    auto mine = settings();
    auto options = controllerFor(mine);
    options.sendPeriod = 4;
    options.clock = timing::now;
    connect(mine, options);
    const std::jthread running([&](const std::stop_token& stop) { controller_->run(stop); });
    if (!whyNot([&] {
           device_->open();
           device_->arm();
         }).empty()) {
      continue;  // the computer was too busy
    }
    const auto tick = [&](double force) {
      device_->pacer()->wait(soon(10 * kMillisecond));
      device_->read(0.004);
      device_->command(force, 0.0);
    };
    for (int k = 0; k < 50; ++k) tick(10.0);
    hasPushed = hasPushed || std::abs(report().force + 10.0) < 0.01;
    if (isFaulted()) continue;
    const std::int64_t begin = timing::now();
    order("stall 500");
    const std::int64_t until = soon(2 * kSecond);
    while ((!isFaulted() || report().hasOverlay) && timing::now() < until) tick(10.0);
    EXPECT_TRUE(isFaulted());
    after = report().overlayZeroAt - begin;
  }
  EXPECT_TRUE(hasPushed);
  EXPECT_GT(after, 0);
  EXPECT_LE(after, 50 * kMillisecond);
}

}  // namespace iiwa_faults_test
}  // namespace haptics::devices
