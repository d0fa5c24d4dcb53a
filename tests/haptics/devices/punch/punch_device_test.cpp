// A punch on its serial line: samples, forces, and what is counted.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/haptics/devices/punch/emulated_punch.h"
#include "tests/support/allocation_counter.h"

namespace haptics::devices {
namespace punch_device_test {

using namespace emulated_punch;

class PunchDeviceTest : public EmulatedPunch {};

TEST_F(PunchDeviceTest, ExchangesAThousandSamplesAtTheBoardsOwnPace) {
  connect({});
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Closed);
  device_->open();
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Open);
  device_->arm();
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Armed);
  int samples = 0;
  std::uint64_t received = 0;
  const std::int64_t until = soon(kPatience);
  while (samples < 1000 && timing::now() < until) {
    samples += exchange(1.0).status == DeviceStatus::Ok ? 1 : 0;
    if (isFaulted()) {
      received += device_->link().received;
      device_->open();
      device_->arm();
    }
  }
  EXPECT_EQ(samples, 1000);
  exchange(1.0);
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Running);
  const auto link = device_->link();
  EXPECT_TRUE(link.hasLink);
  EXPECT_GE(received + link.received, 1000U);
  EXPECT_EQ(link.lost + link.doubled + link.late + link.damaged + link.restarts, 0U);
  EXPECT_GT(link.roundTrip.count(), 0U);
  device_->disarm();
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Open);
  EXPECT_TRUE(waitUntil([&] { return !board_->isArmed(); }));
  EXPECT_TRUE(device_->fault().empty());
}

TEST_F(PunchDeviceTest, FollowsTheTravel) {
  connect({});
  openAndHold();
  double most = 0.0;
  for (int i = 0; i < 1500; ++i) {
    const auto sample = turn(0.5);
    if (sample.status != DeviceStatus::Ok) continue;
    ASSERT_NEAR(sample.travel, board_->travel(), 0.51 * kTravelPerCount);
    most = std::max(most, sample.travel);
  }
  EXPECT_GT(most, 8.0);
}

TEST_F(PunchDeviceTest, AppliesItsCalibrationToTravel) {
  connect(atRest());
  auto other = settings(board_->port());
  other.travelPerCount = -0.01;
  other.travelAtZero = 3.0;
  device_ = std::make_unique<PunchDevice>(other);
  board_->order("leap 100");
  openAndHold();
  const auto sample = turn(0.0);
  EXPECT_NEAR(
      sample.travel, 3.0 - 0.01 * board_->ask([](const auto& e) { return e.counts(); }), 1e-9);
}

TEST_F(PunchDeviceTest, CountsNoLeapForASingleCountOfACoarseEncoder) {
  connect(atRest());
  auto coarse = settings(board_->port());
  coarse.travelPerCount = 1.0;  // more than a hand moves in a period
  device_ = std::make_unique<PunchDevice>(coarse);
  openAndHold();
  for (int i = 0; i < 5; ++i) {
    board_->order("leap 1");
    turn(0.0);
  }
  EXPECT_EQ(device_->link().leaps, 0U);
  board_->order("leap 5");
  turn(0.0);
  EXPECT_GE(device_->link().leaps, 1U);
}

TEST_F(PunchDeviceTest, GivesTheForceThatIsCommanded) {
  connect(atRest());
  openAndHold();
  for (const double force : {3.3333, -2.0, 0.0123, 7.0}) {
    for (int i = 0; i < 200 && std::abs(board_->force() - force) > 0.001 * kNewtonsPerVolt; ++i) {
      turn(force);
      timing::sleepUntil(soon(kMillisecond / 4));
    }
    EXPECT_NEAR(board_->force(), force, 0.001 * kNewtonsPerVolt);
  }
}

TEST_F(PunchDeviceTest, ClipsAForceThatItDoesNotHaveAndCountsIt) {
  connect(atRest());
  auto weak = settings(board_->port());
  weak.maxVoltage = 6.0;
  device_ = std::make_unique<PunchDevice>(weak);
  openAndHold();
  EXPECT_NEAR(device_->capabilities().maxForce, 6.0 * kNewtonsPerVolt, 1e-12);
  std::uint64_t clipped = device_->link().clipped;
  const double most = 6.0 * kNewtonsPerVolt;
  for (int i = 0; i < 500 && (i < 100 || std::abs(board_->force() - most) > 0.001); ++i) {
    turn(100.0);
    ++clipped;
    timing::sleepUntil(soon(kMillisecond / 4));
  }
  EXPECT_EQ(device_->link().clipped, clipped);
  EXPECT_NEAR(board_->force(), most, 0.001);
  turn(most);
  EXPECT_EQ(device_->link().clipped, clipped);
}

TEST_F(PunchDeviceTest, GivesNoForceForACommandThatIsNotFinite) {
  connect(atRest());
  openAndHold();
  for (const double bad : {std::nan(""), double{INFINITY}, -double{INFINITY}}) {
    for (int i = 0; i < 60; ++i) {
      turn(bad);
      ASSERT_EQ(board_->force(), 0.0);
    }
  }
}

TEST_F(PunchDeviceTest, AllocatesNothingInAnExchange) {
  connect({});
  openAndHold();
  std::size_t count = 0;
  for (int i = 0; i < 500; ++i) {
    board_->step();
    const tests::AllocationCounter allocations;
    exchange(1.0);
    count += allocations.count();
  }
  EXPECT_EQ(count, 0U);
}

TEST_F(PunchDeviceTest, CountsExactlyWhatWentWrongOnTheLine) {
  connect({});
  const auto injected = [&] { return board_->ask([](const auto& e) { return e.injected(); }); };
  const std::int64_t until = soon(kPatience);
  emulators::InjectedCounts before;
  do {
    board_->goOn();
    openAndHold();
    before = injected();
    for (const char* order :
         {"drop 7", "double 5", "reorder 3", "delay 2", "damage 4", "garbage 6", "drop 1"}) {
      board_->order(order);
      for (int i = 0; i < 20; ++i) turn(1.0);
    }
    for (int i = 0; i < 20; ++i) turn(1.0);
  } while (isFaulted() && timing::now() < until);
  EXPECT_FALSE(isFaulted()) << base::describe(device_->fault());
  const auto done = injected();
  const auto all = [&](Fault fault) { return done[fault] - before[fault]; };
  EXPECT_EQ(all(Fault::Drop), 8U);
  EXPECT_EQ(all(Fault::Delay), 2U);
  EXPECT_EQ(all(Fault::Garbage), 6U);
  const auto link = device_->link();
  EXPECT_EQ(link.lost, 8U + 4U);  // a damaged frame is not there either
  EXPECT_EQ(link.doubled, 5U);
  EXPECT_EQ(link.late, 3U + 2U);
  EXPECT_EQ(link.damaged, 4U + 6U);
  EXPECT_EQ(link.restarts, 0U);
  device_->arm();
  EXPECT_EQ(device_->link().lost + device_->link().damaged, 0U);  // and begins anew
}

TEST_F(PunchDeviceTest, IgnoresAFrameThatCameLate) {
  connect({});
  openAndHold();
  board_->order("reorder 100");
  std::int64_t before = 0;
  for (int i = 0; i < 600 && !isFaulted(); ++i) {
    const auto sample = turn(1.0);
    if (sample.status == DeviceStatus::NotAnswering) break;
    EXPECT_GE(sample.deviceTime, before);
    before = sample.deviceTime;
  }
  EXPECT_GT(board_->injected(Fault::Reorder), 0U);
}

TEST_F(PunchDeviceTest, TakesNoForceUnlessArmed) {
  connect(atRest());
  EXPECT_TRUE(says(whyNot([&] { device_->arm(); }), "is not ready"));
  device_->command(5.0, 0.0);
  EXPECT_EQ(device_->read(0.001).status, DeviceStatus::NotAnswering);
}

TEST_F(PunchDeviceTest, FindsHowFastTheBoardsClockGoes) {
  auto options = atRest();
  options.clockDrift = 100.0;
  connect(options);
  double drift = 0.0;
  for (int i = 0; i < 3 && std::abs(drift + 100.0) >= 20.0; ++i) {
    openAndHold();
    const std::int64_t until = soon(2500 * kMillisecond);
    while (timing::now() < until && !isFaulted()) {
      turn(0.0);
      timing::sleepUntil(soon(kMillisecond));
    }
    drift = device_->link().drift.value_or(0.0);
    board_->goOn();
  }
  EXPECT_NEAR(drift, -100.0, 20.0);  // ours is the slower one
}

}  // namespace punch_device_test
}  // namespace haptics::devices
