#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "haptics/emulators/fri_controller.h"
#include "tests/haptics/emulators/stepped_session.h"

namespace haptics::emulators {
namespace fri_faults_test {

using tests::quick;
using tests::SteppedSession;
using tests::time;
using wire::fri::Version;
using State = wire::fri::SessionState;
using Level = ConnectionQuality::Level;

FriController::Options checked() {
  auto options = quick();
  options.version = Version::V2_7;  // its CRC shows every damage
  return options;
}

/// A session in which nothing has gone wrong, for long enough.
class FriFaults : public testing::Test {
 protected:
  FriFaults() {
    EXPECT_TRUE(session_.goTo(State::CommandingActive));
    session_.go(100);
  }

  const tests::AnsweringClient::Seen& seen() const { return session_.client.seen(); }

  SteppedSession session_{checked()};
};

TEST_F(FriFaults, AreNoneWithoutAnOrder) {
  session_.go(500);
  const auto report = session_.report();
  EXPECT_EQ(seen().datagrams, report.messages);
  EXPECT_EQ(seen().sound, report.messages);
  EXPECT_EQ(session_.client.missing() + seen().doubled + seen().late, 0U);
  EXPECT_EQ(report.answers.taken, seen().sound - 2);  // two were in Idle
}

TEST_F(FriFaults, DropLosesMessages) {
  session_.order("drop 4");
  session_.go(20);
  EXPECT_EQ(session_.client.missing(), 4U);
  EXPECT_EQ(session_.report().injected[Fault::Drop], 4U);
  EXPECT_EQ(session_.report().answers.missed, 4U);
  EXPECT_EQ(session_.report().state, State::CommandingActive);
}

TEST_F(FriFaults, DoubleRepeatsMessages) {
  session_.order("double 7");
  session_.go(20);
  EXPECT_EQ(seen().doubled, 7U);
  EXPECT_EQ(session_.report().injected[Fault::Double], 7U);
  EXPECT_EQ(session_.report().answers.doubled, 7U);  // this client answers everything
  EXPECT_EQ(session_.report().answers.missed, 0U);
}

TEST_F(FriFaults, ReorderSwapsMessages) {
  session_.order("reorder 3");
  session_.go(20);
  EXPECT_EQ(seen().late, 3U);
  EXPECT_EQ(session_.client.missing(), 0U);
  EXPECT_EQ(session_.report().injected[Fault::Reorder], 3U);
  EXPECT_EQ(session_.report().answers.late, 3U);
  EXPECT_EQ(session_.report().answers.missed, 3U);
}

TEST_F(FriFaults, DelayHoldsMessagesBackForItsTime) {
  session_.order("delay 1 5");
  session_.go(5);
  EXPECT_EQ(seen().late, 0U);
  session_.go(1);
  EXPECT_EQ(seen().late, 1U);
  session_.order("delay 3 4");
  session_.go(20);
  EXPECT_EQ(seen().late, 4U);
  EXPECT_EQ(session_.client.missing(), 0U);
  EXPECT_EQ(session_.report().injected[Fault::Delay], 4U);
}

TEST_F(FriFaults, GarbageIsSentBetweenMessages) {
  session_.order("garbage 5");
  session_.go(20);
  EXPECT_EQ(seen().malformed, 5U);
  EXPECT_EQ(session_.client.missing(), 0U);
  EXPECT_EQ(session_.report().injected[Fault::Garbage], 5U);
  EXPECT_EQ(seen().datagrams, session_.report().messages + 5);
}

TEST_F(FriFaults, DamageSpoilsMessages) {
  session_.order("damage 6");
  session_.go(20);
  EXPECT_EQ(seen().malformed, 6U);
  EXPECT_EQ(session_.client.missing(), 6U);
  EXPECT_EQ(session_.report().injected[Fault::Damage], 6U);
}

TEST_F(FriFaults, SixJointsAreDetected) {
  session_.order("six-joints 4");
  session_.go(20);
  EXPECT_EQ(seen().jointCount, 4U);
  EXPECT_EQ(session_.client.missing(), 4U);
  EXPECT_EQ(session_.report().sixJoints, 4U);
}

TEST_F(FriFaults, NanIsDetected) {
  session_.order("nan 4");
  session_.go(20);
  EXPECT_EQ(seen().notFinite, 4U);
  EXPECT_EQ(session_.client.missing(), 4U);
  EXPECT_EQ(session_.report().notANumber, 4U);
}

TEST_F(FriFaults, ImpostorsComeFromElsewhereAndAreCaughtWhenAnswered) {
  session_.order("impostor 5");
  session_.go(20);
  EXPECT_EQ(seen().foreign, 5U);
  EXPECT_EQ(session_.report().impostors, 5U);
  EXPECT_EQ(session_.report().impostorAnswers, 0U);
  session_.client.expect(session_.controller->impostor());  // as a client that is not connected
  session_.client.send(session_.client.answer());
  session_.step();
  EXPECT_EQ(session_.report().impostorAnswers, 1U);
}

TEST_F(FriFaults, StallSendsNothingAndCountsAsUnanswered) {
  const auto before = session_.report();
  session_.order("stall 6");
  session_.go(20);
  const auto report = session_.report();
  EXPECT_EQ(report.stalled, 6U);
  EXPECT_EQ(report.messages - before.messages, 14U);
  EXPECT_EQ(report.answers.missed, 6U);
  EXPECT_EQ(session_.client.missing(), 0U);
  session_.go(100);  // so that quality is not the reason
  session_.order("stall 12");
  session_.go(12);
  EXPECT_EQ(session_.report().lastEnd, FriEndReason::AnswersMissing);
}

TEST_F(FriFaults, WrongVersionCannotBeReadUntilItIsTakenBack) {
  session_.order("wrong-version");
  session_.go(5);
  EXPECT_EQ(seen().malformed, 5U);
  EXPECT_EQ(session_.report().wrongVersion, 5U);
  session_.order("wrong-version");
  session_.go(5);
  EXPECT_EQ(seen().malformed, 5U);
}

TEST_F(FriFaults, DamageOneMessageEachWhenSeveralAreOrdered) {
  for (const auto* line : {"drop 1", "damage 1", "six-joints 2", "nan 2", "reorder 1"}) {
    session_.order(line);
  }
  session_.go(30);
  EXPECT_EQ(seen().jointCount, 2U);
  EXPECT_EQ(seen().notFinite, 2U);
  EXPECT_EQ(seen().malformed, 1U);
  EXPECT_EQ(seen().late, 1U);
  EXPECT_EQ(session_.client.missing(), 6U);
}

TEST_F(FriFaults, PoorQualityEndsTheMotionUntilLifted) {
  session_.order("quality poor");
  session_.go(2);
  EXPECT_EQ(session_.report().lastEnd, FriEndReason::QualityLost);
  EXPECT_EQ(session_.client.message().connection->quality, Level::Poor);
  session_.go(200);
  EXPECT_EQ(session_.report().state, State::MonitoringWait);
  session_.order("quality good");
  EXPECT_TRUE(session_.goTo(State::MonitoringReady));
}

TEST_F(FriFaults, SafetyStopIsReportedAndEndsTheMotion) {
  session_.client.wrench = wire::fri::Vector6{0.0, 0.0, -10.0, 0.0, 0.0, 0.0};
  session_.go(5);
  session_.order("safety-stop");
  session_.go(1);
  EXPECT_EQ(session_.report().lastEnd, FriEndReason::SafetyStop);
  EXPECT_EQ(session_.report().overlayZeroAt, time());
  const auto info = *session_.client.message().robotInfo;
  EXPECT_EQ(info.safetyState, wire::fri::SafetyState::StopLevel1);
  EXPECT_EQ(info.driveStates.items[0], wire::fri::DriveState::Off);
  session_.order("motion");
  session_.go(300);
  EXPECT_EQ(session_.report().state, State::MonitoringReady);
  session_.order("safety-reset");
  EXPECT_TRUE(session_.goTo(State::CommandingActive));
}

TEST_F(FriFaults, RestartCountsFromZero) {
  session_.order("restart");
  session_.go(1);
  EXPECT_EQ(session_.report().state, State::Idle);
  EXPECT_EQ(session_.client.message().header.sequence, 0U);
  EXPECT_EQ(session_.report().lastEnd, FriEndReason::Restart);
  EXPECT_TRUE(session_.goTo(State::CommandingActive));
}

TEST_F(FriFaults, IdleEndsTheSession) {
  session_.order("idle");
  session_.go(300);
  EXPECT_EQ(session_.report().state, State::Idle);
  EXPECT_EQ(session_.report().lastEnd, FriEndReason::Idle);
  session_.order("motion");
  EXPECT_TRUE(session_.goTo(State::CommandingActive));
}

TEST_F(FriFaults, OfAnswersAreCounted) {
  auto& client = session_.client;
  const auto before = session_.report().answers;
  const auto answerOnce = [&] {
    session_.step();
    session_.overhearAll();
    return client.answer();
  };
  auto command = answerOnce();
  client.send(command);
  client.send(command);  // doubled
  command = answerOnce();
  command.header.identifier = wire::fri::kMonitoring;
  client.send(command);
  command = answerOnce();
  command.header.reflected += 5;  // never sent
  client.send(command);
  client.sequence += 3;  // lost
  command = answerOnce();
  client.send(command);
  session_.receiveAll();
  const auto answers = session_.report().answers;
  EXPECT_EQ(answers.doubled - before.doubled, 1U);
  EXPECT_EQ(answers.wrongIdentifier, 1U);
  EXPECT_EQ(answers.toUnknownMessage, 1U);
  EXPECT_EQ(answers.lost, 6U);  // three that were not sent, three that were not taken
  EXPECT_EQ(answers.taken - before.taken, 1U);  // the first came after three more messages
  EXPECT_EQ(answers.late, 1U);
  client.sequence = 0;
  client.send(answerOnce());
  session_.receiveAll();
  EXPECT_EQ(session_.report().answers.restarts, 1U);
}

TEST_F(FriFaults, FromOtherSendersAreCounted) {
  devices::DatagramSocket stranger(devices::Endpoint{});
  const std::array<std::uint8_t, 3> bytes{1, 2, 3};
  stranger.send(bytes, session_.controller->local());
  ASSERT_TRUE(session_.controller->receive(time() + tests::kPatience));
  EXPECT_EQ(session_.report().answers.unexpectedSender, 1U);
  EXPECT_EQ(session_.report().answers.undecodable, 0U);
}

TEST_F(FriFaults, InvalidCommandsAreExplained) {
  for (const auto* line :
       {"",
        "  ",
        "explode",
        "drop",
        "drop 0",
        "drop -1",
        "drop x",
        "drop 1 2",
        "delay 1",
        "quality",
        "quality 1",
        "quality fair",
        "idle 1",
        "drop 99999999999999999999",
        "DROP 1"}) {
    const auto reply = session_.controller->command(line);
    EXPECT_FALSE(reply.isAccepted) << line;
    EXPECT_FALSE(reply.text.empty()) << line;
  }
  EXPECT_TRUE(session_.controller->command("  drop\t1 ").isAccepted);
}

TEST_F(FriFaults, StatusReportsEverythingInOneLine) {
  const auto reply = session_.controller->command("status");
  EXPECT_TRUE(reply.isAccepted);
  for (const std::string_view part :
       {"state=commanding-active ",
        "quality=excellent ",
        "force_n=0 ",
        "travel_m=",
        "missed=0 ",
        "injected_drop=0 ",
        "zero_at_ns=0 ",
        "end=\"no motion has ended\""}) {
    EXPECT_NE(reply.text.find(part), std::string::npos) << part << " in " << reply.text;
  }
  EXPECT_EQ(reply.text.find('\n'), std::string::npos);
}

class FriFaultsByChance : public testing::TestWithParam<std::uint64_t> {};

TEST_P(FriFaultsByChance, AreCountedExactly) {
  auto options = checked();
  options.impairment = {
      .shares = {0.01, 0.02, 0.01, 0.01, 0.02, 0.01}, .seed = GetParam(), .delay = 3};
  SteppedSession session(options);
  session.go(3000);
  const auto injected = session.report().injected;
  const auto& seen = session.client.seen();
  EXPECT_EQ(injected.passed, 3000U);
  EXPECT_EQ(seen.doubled, injected[Fault::Double]);
  EXPECT_EQ(seen.late, injected[Fault::Reorder] + injected[Fault::Delay]);
  EXPECT_EQ(seen.malformed, injected[Fault::Garbage] + injected[Fault::Damage]);
  const std::uint64_t held = 3000 - injected[Fault::Drop] - injected[Fault::Damage] -
                             (seen.sound - seen.doubled);  // at the end, on their way
  EXPECT_LE(held, 4U);
}

INSTANTIATE_TEST_SUITE_P(Seeds, FriFaultsByChance, testing::Range<std::uint64_t>(1, 6));

}  // namespace fri_faults_test
}  // namespace haptics::emulators
