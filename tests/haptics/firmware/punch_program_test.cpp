// The punch's own program: greeting, arming, voltage and how long it lasts, and the clock.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/haptics/firmware/board_bench.h"

namespace haptics::firmware {
namespace punch_program_test {

using namespace board_bench;

class PunchProgramTest : public BoardBench {};

TEST_F(PunchProgramTest, AnswersNothingBeforeHello) {
  send(Arm{.isArmed = true, .expiry = 20});
  send(SetForce{.voltage = 5000, .expiry = 20});
  send(Model{.kind = ModelKind::FiniteElements});
  send(Render{.hash = 1});
  send(Stop{});
  steps(10);
  EXPECT_EQ(said_.frames(), 0U);
  EXPECT_EQ(bench_.voltage, 0);
  EXPECT_FALSE(program_->isArmed());
}

TEST_F(PunchProgramTest, SendsItsIdentityAndThenItsPosition) {
  bench_.position = 123;
  greet();
  ASSERT_EQ(said_.hellos.size(), 1U);
  const Hello& hello = said_.hellos[0];
  EXPECT_EQ(hello.protocolVersion, kProtocolVersion);
  EXPECT_EQ(hello.build, 0x1122334455667788U);
  EXPECT_EQ(hello.serial, 7U);
  EXPECT_EQ(hello.rate, 1000);
  EXPECT_EQ(hello.largestVoltage, 12000);
  EXPECT_EQ(hello.largestSlew, 1200);
  steps(9);
  EXPECT_EQ(said_.states.size(), 10U);
  EXPECT_EQ(state().counts, 123);
  EXPECT_TRUE(has(kNotArmed));
}

TEST_F(PunchProgramTest, RefusesAHostOfAnotherVersion) {
  send(Hello{.protocolVersion = kProtocolVersion + 1});
  send(Arm{.isArmed = true, .expiry = 20});
  send(SetForce{.voltage = 5000, .expiry = 20});
  steps(10);
  EXPECT_EQ(said_.hellos.size(), 1U);
  ASSERT_EQ(said_.stops.size(), 1U);
  EXPECT_EQ(said_.stops[0].reason, StopReason::VersionMismatch);
  EXPECT_EQ(said_.frames(), 2U);
  EXPECT_EQ(bench_.voltage, 0);
}

TEST_F(PunchProgramTest, GivesNoVoltageUnlessArmed) {
  greet();
  EXPECT_EQ(hold(12000, 20), 0);
  EXPECT_TRUE(has(kNotArmed));
  send(Arm{.isArmed = true, .expiry = 20});
  EXPECT_EQ(hold(6000, 20), 6000);
  EXPECT_FALSE(has(kNotArmed));
  send(Arm{.isArmed = false, .expiry = 20});
  EXPECT_EQ(hold(6000, 20), 0);
  EXPECT_TRUE(has(kNotArmed));
  EXPECT_EQ(said_.count(EventCode::Armed), 1);
  EXPECT_EQ(said_.count(EventCode::Disarmed), 1);
}

TEST_F(PunchProgramTest, ReachesAForceNoFasterThanTheSlew) {
  greetAndArm();
  for (const int goal : {12000, -12000, 500, 0}) {
    int before = bench_.voltage;
    for (const std::uint32_t micros : {1000U, 250U, 3000U, 1000U, 1U, 5000U, 999U, 5000U, 5000U}) {
      send(SetForce{.voltage = static_cast<std::int16_t>(goal), .expiry = 20});
      const int now = step(micros);
      EXPECT_LE(std::abs(now - before), 1.2 * micros);
      before = now;
    }
    EXPECT_EQ(before, goal);
  }
}

TEST_F(PunchProgramTest, MovesNoFurtherThanFiveMillisecondsAfterALongerPause) {
  greetAndArm();
  send(SetForce{.voltage = 12000, .expiry = 20});
  EXPECT_EQ(step(1'000'000), 5 * 1200);
}

TEST_F(PunchProgramTest, ReportsSaturation) {
  greetAndArm();
  for (const int asked : {12001, 32767, -32768}) {
    EXPECT_EQ(hold(asked, 30), asked > 0 ? 12000 : -12000);
    EXPECT_TRUE(has(kSaturated));
    hold(12000, 2);
    EXPECT_FALSE(has(kSaturated));
  }
}

TEST_F(PunchProgramTest, SwitchesTheForceOffWhenItExpires) {
  greetAndArm();
  for (const std::uint8_t expiry : std::initializer_list<std::uint8_t>{1, 5, 10, 20}) {
    ASSERT_EQ(hold(12000, 30, expiry), 12000);
    const auto fired = said_.count(EventCode::WatchdogFired);
    for (int age = 1; age <= expiry; ++age) {
      EXPECT_EQ(step(), 12000) << age;
      EXPECT_FALSE(has(kExpired));
    }
    EXPECT_EQ(step(), 12000 - 1200);
    EXPECT_TRUE(has(kExpired));
    for (int i = 0; i < 9; ++i) step();
    EXPECT_EQ(bench_.voltage, 0);
    steps(5);
    EXPECT_TRUE(has(kExpired));
    EXPECT_EQ(said_.count(EventCode::WatchdogFired), fired + 1);
  }
}

TEST_F(PunchProgramTest, IsGivenForceAgainAfterAShortPause) {
  greetAndArm();
  hold(6000, 10);
  steps(25);
  ASSERT_EQ(bench_.voltage, 0);
  EXPECT_EQ(hold(6000, 10), 6000);
  EXPECT_FALSE(has(kExpired));
  EXPECT_TRUE(program_->isArmed());
}

TEST_F(PunchProgramTest, KeepsNoForceLongerThanItWasArmedFor) {
  greetAndArm(3);
  ASSERT_EQ(hold(6000, 10, 20), 6000);
  steps(3);
  EXPECT_EQ(bench_.voltage, 6000);
  EXPECT_EQ(step(), 4800);
}

TEST_F(PunchProgramTest, DisarmsWhenTheHostStopsSending) {
  greetAndArm();
  hold(6000, 10);
  steps(40);
  EXPECT_TRUE(program_->isArmed());
  step();
  EXPECT_FALSE(program_->isArmed());
  EXPECT_TRUE(has(kNotArmed));
  EXPECT_EQ(said_.count(EventCode::Disarmed), 1);
  EXPECT_EQ(hold(6000, 10), 0);  // until it is armed again
}

TEST_F(PunchProgramTest, StaysArmedWithoutForceWhenTheHostSendsOtherMessages) {
  greetAndArm();
  hold(6000, 10);
  for (int i = 0; i < 200; ++i) {
    send(Model{.kind = ModelKind::FiniteElements});
    step();
  }
  EXPECT_TRUE(program_->isArmed());
  EXPECT_EQ(bench_.voltage, 0);
  EXPECT_EQ(said_.count(EventCode::WatchdogFired), 1);
}

TEST_F(PunchProgramTest, GivesNoOldForceWhenTheClockHasGoneRound) {
  auto patient = limits();
  patient.silence = 60'000;
  begin(patient);
  greetAndArm();
  hold(6000, 10);
  for (int i = 0; i < 80; ++i) {  // 80 minutes
    send(Model{.kind = ModelKind::FiniteElements});
    step(59'999'999);
    if (i > 2) {
      ASSERT_EQ(bench_.voltage, 0) << i;
    }
  }
  const std::uint32_t age = bench_.time - 11'000;
  step(0U - age);  // by the clock, the last force is as good as new
  step();
  EXPECT_EQ(bench_.voltage, 0);
}

TEST_F(PunchProgramTest, IsNotDisturbedWhenTheClockWraps) {
  begin(limits(), 0U - 30'500U);
  greetAndArm();
  ASSERT_EQ(hold(6000, 20), 6000);
  int wrapped = 0;
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(hold(6000, 1), 6000);
    wrapped += has(kClockWrapped) ? 1 : 0;
  }
  EXPECT_EQ(wrapped, 1);
  EXPECT_EQ(state().lateLoops, 0);
  EXPECT_EQ(said_.count(EventCode::WatchdogFired), 0);
}

TEST_F(PunchProgramTest, SwitchesTheForceOffInTimeWhenTheClockWraps) {
  begin(limits(), 0U - 27'500U);
  greetAndArm();
  ASSERT_EQ(hold(6000, 20), 6000);  // five milliseconds are left
  steps(10);
  EXPECT_LT(bench_.time, 10'000U);
  EXPECT_EQ(bench_.voltage, 6000);
  EXPECT_EQ(step(), 4800);
  steps(4);
  EXPECT_EQ(bench_.voltage, 0);
}

TEST_F(PunchProgramTest, IsDisarmedByAnotherHello) {
  greetAndArm();
  ASSERT_EQ(hold(6000, 10), 6000);
  send(Hello{});
  EXPECT_EQ(hold(6000, 1), 4800);
  EXPECT_FALSE(program_->isArmed());
  EXPECT_EQ(hold(6000, 10), 0);
  EXPECT_TRUE(has(kNotArmed));
  EXPECT_EQ(said_.hellos.size(), 2U);
}

TEST_F(PunchProgramTest, IsDisarmedByStop) {
  greetAndArm();
  hold(6000, 10);
  send(Stop{StopReason::HostFault});
  EXPECT_EQ(step(), 4800);
  EXPECT_FALSE(program_->isArmed());
}

}  // namespace punch_program_test
}  // namespace haptics::firmware
