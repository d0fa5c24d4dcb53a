#include "haptics/emulators/fri_controller.h"

#include <array>
#include <cstdint>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/haptics/emulators/stepped_session.h"
#include "tests/support/allocation_counter.h"

namespace haptics::emulators {
namespace fri_controller_test {

using tests::kPatience;
using tests::quick;
using tests::SteppedSession;
using tests::time;
using tests::torque;
using wire::fri::ClientCommandMode;
using wire::fri::ControlMode;
using wire::fri::Version;
using State = wire::fri::SessionState;
using Level = ConnectionQuality::Level;

TEST(FriController, GoesThroughAllStatesAndBackToIdle) {
  auto options = quick();
  options.dwellTimes.commandingActive = 20;
  SteppedSession session(options);
  std::vector<State> states;
  for (int i = 0; i < 200; ++i) {
    session.go(1);
    const State told = session.client.message().connection->state;
    if (states.empty() || states.back() != told) states.push_back(told);
  }
  EXPECT_EQ(
      states,
      (std::vector{
          State::Idle,
          State::MonitoringWait,
          State::MonitoringReady,
          State::CommandingWait,
          State::CommandingActive,
          State::Idle}));
  EXPECT_EQ(session.report().lastEnd, FriEndReason::Completed);
  EXPECT_EQ(session.report().answers.missed, 0U);
}

TEST(FriController, IsReadyWhenTheConnectionIsGood) {
  SteppedSession session(quick());
  session.go(3);  // the third message is the first to be answered
  EXPECT_EQ(session.report().state, State::MonitoringWait);
  session.go(89);
  EXPECT_EQ(session.report().state, State::MonitoringWait);
  EXPECT_EQ(session.report().quality, Level::Good);
  session.go(1);
  EXPECT_EQ(session.report().state, State::MonitoringReady);
}

TEST(FriController, LetsTheSurgeonMoveTheToolAndTheWrenchHoldIt) {
  double travels[2] = {};
  for (int i = 0; i < 2; ++i) {
    SteppedSession session(quick());
    ASSERT_TRUE(session.goTo(State::CommandingActive));
    const double before = session.report().travel;
    session.client.wrench = wire::fri::Vector6{0.0, 0.0, i == 0 ? 0.0 : -40.0, 0.0, 0.0, 0.0};
    session.go(1500);
    ASSERT_EQ(session.report().state, State::CommandingActive) << session.controller->status();
    EXPECT_EQ(session.report().force, i == 0 ? 0.0 : -40.0);
    travels[i] = session.report().travel - before;
  }
  EXPECT_GT(travels[0], 0.01);
  EXPECT_LT(travels[1], travels[0] - 0.01);
}

TEST(FriController, EndsTheMotionWhenElevenAnswersAreMissing) {
  SteppedSession session(quick());
  ASSERT_TRUE(session.goTo(State::CommandingActive));
  session.client.wrench = wire::fri::Vector6{0.0, 0.0, -30.0, 0.0, 0.0, 0.0};
  session.go(100);
  EXPECT_TRUE(session.report().hasOverlay);
  session.goSilently(FriSession::kMostMissed + 1);  // the answer to the last is not yet due
  EXPECT_EQ(session.report().state, State::CommandingActive);
  EXPECT_TRUE(session.report().hasOverlay);
  session.goSilently(1);
  const FriReport report = session.report();
  EXPECT_EQ(report.state, State::MonitoringWait);
  EXPECT_EQ(report.lastEnd, FriEndReason::AnswersMissing);
  EXPECT_EQ(report.quality, Level::Poor);
  EXPECT_FALSE(report.hasOverlay);
  EXPECT_EQ(report.force, 0.0);
  EXPECT_EQ(report.overlayZeroAt, time());
  EXPECT_EQ(report.endAt, time());
}

TEST(FriController, HoldsTheArmAfterAMotionThatFailed) {
  SteppedSession session(quick());
  ASSERT_TRUE(session.goTo(State::CommandingActive));
  session.go(300);
  session.goSilently(12);
  ASSERT_EQ(session.report().state, State::MonitoringWait);
  session.goSilently(500);  // until what swung has come to rest
  const double travel = session.report().travel;
  session.goSilently(3000);
  EXPECT_NEAR(session.report().travel, travel, 0.008);  // a stiff arm gives way by a little
}

TEST(FriController, DoesNotTryAgainUnlessTheProgramDoes) {
  SteppedSession session(quick());
  ASSERT_TRUE(session.goTo(State::CommandingActive));
  session.goSilently(12);
  session.go(300);
  EXPECT_EQ(session.report().state, State::MonitoringReady);
  session.order("motion");
  EXPECT_TRUE(session.goTo(State::CommandingActive));
}

TEST(FriController, NeedsTorqueEveryFiveMilliseconds) {
  SteppedSession session(torque());
  session.client.torque = wire::fri::Joints{0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5};
  ASSERT_TRUE(session.goTo(State::CommandingActive));
  session.go(5);
  session.goSilently(4);
  session.go(1);
  EXPECT_EQ(session.report().state, State::CommandingActive);
  session.goSilently(5);  // 5 ms without
  EXPECT_EQ(session.report().state, State::CommandingActive);
  session.goSilently(1);
  EXPECT_EQ(session.report().lastEnd, FriEndReason::CommandsTooRare);
  EXPECT_EQ(session.report().overlayZeroAt, time());
}

struct Wrong {
  FriEndReason end;
  int joint;
  void (*make)(wire::fri::CommandData& data);
  bool isTorque = false;
};

class FriControllerLimits : public testing::TestWithParam<Wrong> {};

TEST_P(FriControllerLimits, EndTheMotionWithTheirReason) {
  const Wrong& wrong = GetParam();
  SteppedSession session(wrong.isTorque ? torque() : quick());
  ASSERT_TRUE(session.goTo(State::CommandingActive));
  session.go(5);
  session.step();
  session.overhearAll();
  auto command = session.client.answer();
  wrong.make(*command.data);
  session.client.send(command);
  session.receiveAll();
  EXPECT_EQ(session.report().lastEnd, wrong.end) << session.controller->status();
  EXPECT_EQ(session.report().endJoint, wrong.joint);
  EXPECT_EQ(session.report().state, State::MonitoringWait);
}

using Data = wire::fri::CommandData;
INSTANTIATE_TEST_SUITE_P(
    Commands,
    FriControllerLimits,
    testing::Values(
        Wrong{FriEndReason::PositionMissing, 0, [](Data& d) { d.jointPosition.reset(); }},
        Wrong{FriEndReason::WrenchMissing, 0, [](Data& d) { d.wrench.reset(); }},
        Wrong{FriEndReason::TorqueMissing, 0, [](Data& d) { d.jointTorque.reset(); }, true},
        Wrong{FriEndReason::PositionJump, 3, [](Data& d) { (*d.jointPosition)[2] += 0.003; }},
        Wrong{FriEndReason::PositionLimit, 2, [](Data& d) { (*d.jointPosition)[1] = 2.2; }},
        Wrong{FriEndReason::WrenchLimit, 0, [](Data& d) { (*d.wrench)[2] = -140.1; }},
        Wrong{FriEndReason::WrenchLimit, 0, [](Data& d) { (*d.wrench)[4] = 40.1; }},
        Wrong{FriEndReason::TorqueLimit, 7, [](Data& d) { (*d.jointTorque)[6] = 40.1; }, true}));

TEST(FriController, FollowsAPositionWithinTheVelocityLimit) {
  auto options = quick();
  options.arm.control = ControlMode::Position;
  options.arm.command = ClientCommandMode::JointPosition;
  options.arm.hasHand = false;
  SteppedSession session(options);
  ASSERT_TRUE(session.goTo(State::CommandingActive));
  for (int i = 0; i < 100; ++i) {
    session.client.offset += 0.001;
    session.go(1);
  }
  session.go(300);
  ASSERT_EQ(session.report().state, State::CommandingActive) << session.controller->status();
  EXPECT_NEAR((*session.client.message().monitorData->measuredPosition)[6], 0.1, 1e-3);
  EXPECT_TRUE(session.report().hasOverlay);
}

TEST(FriController, WaitsForAMirrorAndEndsAfterTenSeconds) {
  auto options = quick();
  options.sendPeriod = 100;
  SteppedSession session(options);
  session.client.wrench.reset();
  ASSERT_TRUE(session.goTo(State::CommandingWait));
  session.go(100);
  EXPECT_EQ(session.report().state, State::CommandingWait);
  session.go(1);
  EXPECT_EQ(session.report().lastEnd, FriEndReason::NotMirrored);
}

TEST(FriController, NeedsOnlyEveryThirdAnswerWithAMultiplierOfThree) {
  auto options = quick();
  options.receiveMultiplier = 3;
  SteppedSession session(options);
  ASSERT_TRUE(session.goTo(State::CommandingActive));
  session.go(300);
  EXPECT_EQ(session.report().state, State::CommandingActive);
  EXPECT_EQ(session.report().answers.missed, 0U);
  EXPECT_NEAR(
      static_cast<double>(session.report().answers.taken),
      static_cast<double>(session.report().messages) / 3.0,
      3.0);
}

class FriControllerCombinations
    : public testing::TestWithParam<
          std::tuple<Version, std::pair<ControlMode, ClientCommandMode>>> {};

TEST_P(FriControllerCombinations, RunWithoutAMiss) {
  const auto& [version, modes] = GetParam();
  auto options = quick();
  options.version = version;
  options.arm.control = modes.first;
  options.arm.command = modes.second;
  SteppedSession session(options);
  ASSERT_TRUE(session.goTo(State::CommandingActive)) << session.controller->status();
  session.go(200);
  EXPECT_EQ(session.report().state, State::CommandingActive) << session.controller->status();
  const auto& answers = session.report().answers;
  EXPECT_EQ(answers.missed + answers.lost + answers.late + answers.undecodable, 0U);
  const auto& message = session.client.message();
  EXPECT_EQ(session.client.seen().sound, session.report().messages);
  EXPECT_EQ(message.header.reflected + 2, session.client.sequence);
  EXPECT_EQ(message.robotInfo->controlMode, modes.first);
  EXPECT_EQ(message.ipoData->commandMode, modes.second);
  EXPECT_EQ(message.robotInfo->driveStates.count, 7U);
  EXPECT_EQ(message.monitorData->commandedPosition.has_value(), version < Version::V2_5);
  EXPECT_EQ(message.monitorData->pose.has_value(), version >= Version::V2_5);
  EXPECT_EQ(message.monitorData->externalForce.has_value(), version == Version::V2_7);
}

constexpr std::array kVersions{
    Version::V1_11, Version::V1_14, Version::V1_15, Version::V1_16, Version::V2_5, Version::V2_7};
constexpr std::array kModes{
    std::pair(ControlMode::CartesianImpedance, ClientCommandMode::Wrench),
    std::pair(ControlMode::JointImpedance, ClientCommandMode::Torque),
    std::pair(ControlMode::Position, ClientCommandMode::JointPosition),
    std::pair(ControlMode::CartesianImpedance, ClientCommandMode::JointPosition),
    std::pair(ControlMode::JointImpedance, ClientCommandMode::JointPosition)};

INSTANTIATE_TEST_SUITE_P(
    VersionsAndModes,
    FriControllerCombinations,
    testing::Combine(testing::ValuesIn(kVersions), testing::ValuesIn(kModes)));

TEST(FriController, AllocatesNothingInAPeriod) {
  SteppedSession session(quick());
  ASSERT_TRUE(session.goTo(State::CommandingActive));
  session.order("drop 3");
  session.order("delay 3 4");
  session.order("garbage 3");
  session.order("six-joints 1");
  const tests::AllocationCounter allocations;
  for (int i = 0; i < 100; ++i) {
    session.controller->step();
    session.controller->receive(0);
  }
  EXPECT_EQ(allocations.count(), 0U);
}

TEST(FriController, RunsOnItsOwnThread) {
  tests::AnsweringClient client(Version::V1_15);
  client.wrench = wire::fri::Vector6{};
  auto options = quick();
  options.sendPeriod = 2;
  options.client = client.endpoint();
  FriController controller(options);
  client.expect(controller.local());
  std::jthread thread([&controller](const std::stop_token& stop) { controller.run(stop); });
  // How good the connection is depends on what else this machine does; that it is there does not.
  const std::int64_t end = timing::now() + kPatience;
  while (controller.report().answers.taken < 100 && timing::now() < end) {
    client.hear(kPatience);
  }
  EXPECT_GE(controller.report().answers.taken, 100U);
}

TEST(FriController, RefusesInvalidOptions) {
  const auto refuses = [](const auto& change) {
    FriController::Options options;
    change(options);
    EXPECT_THROW(FriController{options}, std::invalid_argument);
  };
  refuses([](auto& o) { o.sendPeriod = 0; });
  refuses([](auto& o) { o.sendPeriod = 101; });
  refuses([](auto& o) { o.receiveMultiplier = 21; });
  refuses([](auto& o) { o.client.address = 0x0A000001; });
  refuses([](auto& o) { o.local.address = 0; });
  refuses([](auto& o) { o.client.port = 0; });
  refuses([](auto& o) { o.arm.control = ControlMode::Position; });
  refuses([](auto& o) { o.arm.command = ClientCommandMode::Torque; });
  refuses([](auto& o) { o.dwellTimes.idle = -1; });
  refuses([](auto& o) {
    o = torque();
    o.sendPeriod = 6;
  });
  FriController::Options elsewhere;
  elsewhere.client.address = 0x0A000001;
  elsewhere.allowsOtherHosts = true;
  EXPECT_NO_THROW(FriController{elsewhere});
}

}  // namespace fri_controller_test
}  // namespace haptics::emulators
