// What a punch does when its line is unplugged, its board falls silent, or its hardware fails.
#include <optional>

#include <gtest/gtest.h>

#include "tests/haptics/devices/punch/emulated_punch.h"

namespace haptics::devices {
namespace punch_faults_test {

using namespace emulated_punch;

class PunchFaultsTest : public EmulatedPunch {};

TEST_F(PunchFaultsTest, LetsGoWithinFiftyMillisecondsWhenItIsUnplugged) {
  connect(atRest());
  std::optional<double> after;
  for (int i = 0; i < 3 && !(after && *after < 50.0); ++i) {
    ASSERT_TRUE(push(4.0));
    board_->order("unplug");
    ASSERT_TRUE(exchangeUntil(4.0, [&](const DeviceSample& sample) {
      return sample.status == DeviceStatus::NotAnswering;
    }));
    EXPECT_EQ(device_->lifecycle(), Lifecycle::Faulted);
    ASSERT_TRUE(waitUntil([&] { return board_->force() == 0.0; }));
    after = board_->ask([](const auto& e) { return e.motorOffAfter(); });
    EXPECT_TRUE(says(whyNot([&] { device_->arm(); }), base::describe(device_->fault())));
    EXPECT_TRUE(says(whyNot([&] { device_->open(); }), "no serial port"));
    board_->order("plug");
  }
  ASSERT_TRUE(after);
  EXPECT_LT(*after, 50.0);
}

TEST_F(PunchFaultsTest, ReconnectsAfterItWasUnplugged) {
  connect(atRest());
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(endsBy("unplug", "unplugged"));
    device_->disarm();
    board_->order("plug");
  }
  EXPECT_TRUE(push(4.0));
  EXPECT_TRUE(device_->fault().empty());
}

TEST_F(PunchFaultsTest, NoticesThatItIsUnpluggedWithoutTicks) {
  connect(atRest());
  device_->open();
  board_->order("unplug");
  EXPECT_TRUE(waitUntil([&] { return isFaulted(); }));
  EXPECT_FALSE(device_->fault().empty());
}

TEST_F(PunchFaultsTest, FaultsWhenTheBoardStopsSending) {
  connect(atRest());
  ASSERT_TRUE(push(4.0));
  const std::int64_t muted = timing::now();
  board_->order("mute 200");
  EXPECT_TRUE(exchangeUntil(4.0, [&](const DeviceSample&) { return isFaulted(); }));
  EXPECT_GT(timing::now() - muted, 45 * kMillisecond);
  EXPECT_TRUE(says(device_->fault(), "has sent nothing for 50 ms"));
  EXPECT_EQ(exchange(4.0).status, DeviceStatus::NotAnswering);
  EXPECT_TRUE(waitUntil([&] { return board_->force() == 0.0; }));
  EXPECT_FALSE(board_->isArmed());
}

TEST_F(PunchFaultsTest, SaysThatOnlyDamagedFramesArrive) {
  connect(atRest());
  EXPECT_TRUE(endsBy("damage 200", "damaged frames only"));
}

TEST_F(PunchFaultsTest, SaysThatTheBoardLetGoBecauseThisComputerStoodStill) {
  connect(atRest(), 40);
  const std::int64_t until = soon(kPatience);
  testing::AssertionResult isSaid = testing::AssertionFailure() << "never pushed back";
  while (!isSaid && timing::now() < until && push(4.0)) {
    timing::sleepUntil(soon(80 * kMillisecond));
    if (!exchangeUntil(4.0, [&](const DeviceSample&) { return isFaulted(); })) break;
    isSaid = says(device_->fault(), "this computer stood still");
  }
  EXPECT_TRUE(isSaid);
}

TEST_F(PunchFaultsTest, FaultsWhenTheBoardIsReset) {
  connect(atRest());
  EXPECT_TRUE(endsBy("reset", "has sent nothing for 50 ms"));
  EXPECT_EQ(board_->force(), 0.0);
  EXPECT_TRUE(push(4.0));  // after open() it is as good as new
}

TEST_F(PunchFaultsTest, FaultsWhenTheBoardHangsAndTheWatchdogReleasesTheForce) {
  connect(atRest());
  EXPECT_TRUE(endsBy("stall 300", "has sent nothing for 50 ms"));
  EXPECT_TRUE(waitUntil([&] { return board_->force() == 0.0; }));
  EXPECT_TRUE(waitUntil([&] { return whyNot([&] { device_->open(); }).empty(); }));
}

TEST_F(PunchFaultsTest, SaysWhatTheBoardFoundBroken) {
  connect(atRest());
  EXPECT_TRUE(endsBy("leap 5000", "its encoder jumps"));
  board_->order("mend");
  EXPECT_TRUE(endsBy("driver-fault", "the motor's driver reports a fault"));
  EXPECT_TRUE(waitUntil([&] { return board_->force() == 0.0; }));
  board_->order("mend");
  EXPECT_TRUE(push(4.0));
}

TEST_F(PunchFaultsTest, FaultsAtAPositionThatItCannotHave) {
  connect(atRest());
  ASSERT_TRUE(push(4.0));  // control: the same board, where it can be
  auto lost = settings(board_->port());
  device_.reset();
  lost.travelAtZero = kTravelPerCount * 2147483648.0;  // 2³¹ counts
  device_ = std::make_unique<PunchDevice>(lost);
  device_->open();
  device_->arm();
  ASSERT_TRUE(exchangeUntil(
      0.0, [&](const DeviceSample& sample) { return sample.status == DeviceStatus::Faulted; }));
  EXPECT_TRUE(says(device_->fault(), "where it cannot be"));
  EXPECT_TRUE(waitUntil([&] { return board_->force() == 0.0; }));
}

}  // namespace punch_faults_test
}  // namespace haptics::devices
