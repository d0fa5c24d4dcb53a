// Faults that the punch's own program latches, and frames that it counts.
#include <limits>

#include <gtest/gtest.h>

#include "tests/haptics/firmware/board_bench.h"

namespace haptics::firmware {
namespace punch_program_faults_test {

using namespace board_bench;

class PunchProgramFaultsTest : public BoardBench {};

struct Latched {
  const char* name;
  std::uint8_t fault;
  EventCode code;
};

class PunchProgramLatches : public BoardBench, public testing::WithParamInterface<Latched> {
 protected:
  void breakIt() {
    if (GetParam().fault == kEncoderFault) bench_.position += 401;
    if (GetParam().fault == kDriverFault) bench_.isFaulty = true;
    if (GetParam().fault == kTooFast) {
      for (int i = 0; i < 8; ++i) {
        bench_.position -= 160;  // 160,000 counts/s
        hold(6000, 1);
      }
    }
  }
};

TEST_P(PunchProgramLatches, UntilItIsArmedAgain) {
  greetAndArm();
  ASSERT_EQ(hold(6000, 10), 6000);
  breakIt();
  hold(6000, 20);
  EXPECT_EQ(bench_.voltage, 0);
  EXPECT_TRUE(has(GetParam().fault));
  EXPECT_EQ(said_.count(GetParam().code), 1);
  bench_.isFaulty = false;
  EXPECT_EQ(hold(6000, 20), 0);  // repaired, and still off
  greet();
  EXPECT_TRUE(has(GetParam().fault));
  send(Arm{.isArmed = true, .expiry = 20});
  EXPECT_EQ(hold(6000, 20), 6000);
  EXPECT_EQ(state().faults, 0);
}

TEST_P(PunchProgramLatches, ReducesTheForceInTheSameIteration) {
  greetAndArm();
  ASSERT_EQ(hold(6000, 10), 6000);
  if (GetParam().fault == kTooFast) return;  // takes some loops to be seen
  breakIt();
  EXPECT_EQ(hold(6000, 1), 4800);
}

INSTANTIATE_TEST_SUITE_P(
    Faults,
    PunchProgramLatches,
    testing::Values(
        Latched{"EncoderLeap", kEncoderFault, EventCode::EncoderFault},
        Latched{"TooFast", kTooFast, EventCode::TooFast},
        Latched{"DriverFault", kDriverFault, EventCode::DriverFault}),
    [](const auto& parameter) { return std::string(parameter.param.name); });

TEST_F(PunchProgramFaultsTest, LatchesADriverThatIsStillBrokenAgain) {
  greetAndArm();
  bench_.isFaulty = true;
  hold(6000, 10);
  send(Arm{.isArmed = true, .expiry = 20});
  EXPECT_EQ(hold(6000, 20), 0);
  EXPECT_TRUE(has(kDriverFault));
}

TEST_F(PunchProgramFaultsTest, AcceptsAnyCountsOfTheEncoder) {
  greetAndArm();
  constexpr auto kMost = std::numeric_limits<std::int32_t>::max();
  for (const std::int32_t position : {kMost, 0, -kMost - 1, 20'000'000, -20'000'000}) {
    send(Arm{.isArmed = true, .expiry = 20});
    hold(6000, 10);
    bench_.position = position;
    hold(6000, 10);
    EXPECT_TRUE(has(kEncoderFault)) << position;
    EXPECT_EQ(bench_.voltage, 0);
    EXPECT_EQ(state().counts, position);
  }
}

TEST_F(PunchProgramFaultsTest, CountsOnWhenTheEncoderWrapsAround) {
  bench_.position = std::numeric_limits<std::int32_t>::max() - 250;
  program_.emplace(bench_, limits());
  greetAndArm();
  for (int i = 0; i < 10; ++i) {
    bench_.position = static_cast<std::int32_t>(static_cast<std::uint32_t>(bench_.position) + 100U);
    hold(1000, 1);
  }
  EXPECT_LT(bench_.position, 0);
  EXPECT_EQ(state().velocity, 100'000);
  EXPECT_EQ(state().faults, 0);
}

TEST_F(PunchProgramFaultsTest, AllowsTheMovementsOfAHand) {
  greetAndArm();
  for (int i = 0; i < 100; ++i) {
    bench_.position += 100;  // 100,000 counts/s
    hold(1000, 1);
  }
  EXPECT_EQ(state().velocity, 100'000);
  EXPECT_EQ(state().faults, 0);
  EXPECT_EQ(bench_.voltage, 1000);
}

TEST_F(PunchProgramFaultsTest, EchoesTheLastFrameThatWasValid) {
  greetAndArm();
  sequence_ = 40'000;
  hold(100, 1);
  EXPECT_EQ(state().echo, 40'001);
  auto damaged = onWire(SetForce{.voltage = 100}, 40'002);
  damaged[3] ^= 0x20;
  put(damaged);
  step();
  EXPECT_EQ(state().echo, 40'001);
  put(onWire(SetForce{.voltage = 100, .expiry = 0}, 40'003));  // no expiry there is
  step();
  EXPECT_EQ(state().echo, 40'001);
  put(onWire(State{}, 40'004));  // not for a device
  step();
  EXPECT_EQ(state().echo, 40'001);
  put(onWire(Arm{.isArmed = true, .expiry = 21}, 40'005));
  step();
  EXPECT_EQ(state().echo, 40'001);
  EXPECT_EQ(state().badFrames, 4);
  sequence_ = 65'534;
  hold(100, 2);
  EXPECT_EQ(state().echo, 0);  // wraps
}

TEST_F(PunchProgramFaultsTest, CountsFramesThatAreDamaged) {
  greetAndArm();
  for (int i = 1; i <= 5; ++i) {
    auto damaged = onWire(SetForce{.voltage = 12000}, 1);
    damaged[static_cast<std::size_t>(i)] ^= 0x80;
    put(damaged);
    step();
    EXPECT_TRUE(has(kBadFrames));
    EXPECT_EQ(state().badFrames, i);
    step();
    EXPECT_FALSE(has(kBadFrames));
  }
  EXPECT_EQ(bench_.voltage, 0);
  EXPECT_EQ(hold(1000, 1), 1000);  // what follows is understood
  greet();
  EXPECT_EQ(state().badFrames, 0);
}

TEST_F(PunchProgramFaultsTest, LimitsTheBytesThatItReadsInALoop) {
  greetAndArm();
  while (bench_.toBoard.size() < 5000) send(SetForce{.voltage = 1200, .expiry = 20});
  std::size_t left = bench_.toBoard.size();
  while (left > 512) {
    step();
    EXPECT_EQ(bench_.toBoard.size(), left - 512);
    left -= 512;
  }
  step();
  EXPECT_TRUE(bench_.toBoard.empty());
  EXPECT_EQ(state().echo, sequence_);  // and loses nothing of it
  EXPECT_EQ(state().badFrames, 0);
}

TEST_F(PunchProgramFaultsTest, CountsLoopsThatCameLate) {
  greet();
  steps(10);
  EXPECT_EQ(state().lateLoops, 0);
  step(1600);
  step(20'000);
  EXPECT_EQ(state().lateLoops, 2);
  greet();
  EXPECT_EQ(state().lateLoops, 0);
}

}  // namespace punch_program_faults_test
}  // namespace haptics::firmware
