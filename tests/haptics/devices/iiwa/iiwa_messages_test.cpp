// What an arm over FRI answers to single messages, which the test makes.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <future>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/devices/iiwa/iiwa_kinematics.h"
#include "tests/haptics/devices/iiwa/emulated_arm.h"

namespace haptics::devices {
namespace iiwa_messages_test {

using namespace emulated_arm;

/// A robot that sends the messages of a test, and collects the answers.
class IiwaMessagesTest : public testing::Test {
 protected:
  IiwaMessagesTest() { message_ = makeMessage(); }

  static MonitoringMessage makeMessage() {
    MonitoringMessage message;
    message.robotInfo.emplace().safetyState = SafetyState::NormalOperation;
    message.monitorData.emplace().measuredPosition = startOfArm();
    message.monitorData->measuredTorque = Joints{};
    message.connection = {
        .state = SessionState::CommandingActive,
        .quality = ConnectionQuality::Excellent,
        .sendPeriod = 5,
        .receiveMultiplier = 1};
    message.ipoData.emplace().jointPosition = startOfArm();
    message.ipoData->commandMode = ClientCommandMode::Wrench;
    return message;
  }

  void say() {
    message_.header.sequence = next_++;
    const std::int64_t time = 1'700'000'000'000'000'000 + 5 * kMillisecond * ++periods_;
    message_.monitorData->timestamp = TimeStamp{
        .seconds = static_cast<std::uint32_t>(time / kSecond),
        .nanoseconds = static_cast<std::uint32_t>(time % kSecond)};
    std::array<std::uint8_t, kLargestDatagram> bytes{};
    const std::size_t count = encode(message_, settings_.version, bytes);
    ASSERT_GT(count, 0U);
    ASSERT_TRUE(robot_.send(std::span(bytes).first(count), client()));
  }
  Endpoint client() const { return {.port = settings_.port}; }

  /// The answers that have come.
  std::vector<CommandMessage> answers() {
    std::vector<CommandMessage> all;
    std::array<std::uint8_t, kLargestDatagram + 1> bytes{};
    while (const auto received = robot_.receive(bytes)) {
      EXPECT_EQ(
          decode(std::span(bytes).first(received->size), settings_.version, all.emplace_back()),
          Refusal::None);
    }
    return all;
  }

  void during(const std::function<void()>& action) {
    auto done = std::async(std::launch::async, action);
    while (done.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready) say();
    done.get();
  }
  void arm() {
    device_ = std::make_unique<IiwaDevice>(settings_);
    armAgain();
  }
  void armAgain() {
    during([this] { device_->open(); });
    during([this] { device_->arm(); });
    tick(0.0);  // what was left over
    answers();
  }
  DeviceSample tick(double force, double torque = 0.0) {
    device_->pacer()->wait(soon(kMillisecond));
    const auto sample = device_->read(0.005);
    device_->command(force, torque);
    return sample;
  }
  DeviceSample turn(double force, double torque = 0.0) {
    say();
    return tick(force, torque);
  }
  /// The wrench in the only answer to one message, taken from its bytes without our codec: field 2
  /// of the command data is a Cartesian vector of six packed doubles (docs/fri.md; golden bytes of
  /// tests/data/fri).
  std::array<double, 6> wrenchInBytesFor(double force, double torque) {
    turn(force, torque);
    std::array<double, 6> wrench{};
    wrench.fill(std::nan(""));
    std::array<std::uint8_t, kLargestDatagram + 1> bytes{};
    const auto received = robot_.receive(bytes);
    EXPECT_TRUE(received);
    if (!received) return wrench;
    constexpr std::array<std::uint8_t, 4> kHead{0x12, 0x32, 0x0a, 0x30};
    const auto datagram = std::span(bytes).first(received->size);
    const auto at = std::search(datagram.begin(), datagram.end(), kHead.begin(), kHead.end());
    const auto left = static_cast<std::size_t>(datagram.end() - at);
    EXPECT_GE(left, kHead.size() + sizeof(wrench)) << "there is no wrench";
    if (left < kHead.size() + sizeof(wrench)) return wrench;
    std::memcpy(wrench.data(), &*at + kHead.size(), sizeof(wrench));
    return wrench;
  }
  /// The wrench in the only answer to one message.
  Vector6 wrenchFor(double force) {
    turn(force);
    const auto all = answers();
    EXPECT_EQ(all.size(), 1U);
    return all.empty() || !all[0].data || !all[0].data->wrench ? Vector6{1e9}
                                                               : *all[0].data->wrench;
  }
  bool isFaulted() const { return device_->lifecycle() == Lifecycle::Faulted; }
  void endsSaying(const std::string& words) {
    EXPECT_EQ(turn(10.0).status, DeviceStatus::Faulted);
    EXPECT_TRUE(isFaulted());
    EXPECT_TRUE(says(device_->fault(), words));
    EXPECT_TRUE(answers().empty());  // a robot that is not answered lets go
  }

  IiwaSettings settings_ = settings();
  DatagramSocket robot_{Endpoint{}};
  MonitoringMessage message_;
  std::uint32_t next_ = 0;
  std::int64_t periods_ = 0;
  std::unique_ptr<IiwaDevice> device_;
};

TEST_F(IiwaMessagesTest, IsAnsweredOnceAndWithItsOwnJoints) {
  arm();
  (*message_.ipoData->jointPosition)[3] += 0.001;
  turn(10.0);
  device_->command(10.0, 0.0);
  tick(10.0);
  const auto all = answers();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].header.reflected, next_ - 1);
  EXPECT_EQ(all[0].data->jointPosition, message_.ipoData->jointPosition);
  EXPECT_FALSE(all[0].data->jointTorque);
}

TEST_F(IiwaMessagesTest, SwitchTheReamerByThePedalsInput) {
  arm();
  EXPECT_TRUE(turn(10.0).isReamerOn);  // no pedal was named
  settings_.pedal = "Pedal";
  arm();
  EXPECT_FALSE(turn(10.0).isReamerOn);  // its input is missing
  using haptics::wire::fri::IoDirection;
  using haptics::wire::fri::IoType;
  using haptics::wire::fri::Name;
  auto* input = message_.monitorData->inputs.add();
  *input = {Name("Pedal"), IoType::Boolean, IoDirection::Input, 1, {}};
  EXPECT_TRUE(turn(10.0).isReamerOn);
  input->digital = 0;
  EXPECT_FALSE(turn(10.0).isReamerOn);
}

TEST_F(IiwaMessagesTest, IsAnsweredAsOftenAsItWants) {
  message_.connection->receiveMultiplier = 3;
  arm();
  for (int i = 0; i < 30; ++i) turn(10.0);
  EXPECT_EQ(answers().size(), 10U);
}

TEST_F(IiwaMessagesTest, TakesTheForceInTheAxesOfTheToolOrTheBase) {
  arm();
  const auto inTool = wrenchFor(10.0);
  EXPECT_NEAR(inTool[2], -10.0, 1e-9);  // the tool's z points down, as the axis does
  device_.reset();
  settings_.wrenchFrame = WrenchFrame::Base;
  settings_.port = tests::freePort();
  arm();
  const auto inBase = wrenchFor(10.0);
  EXPECT_NEAR(inBase[2], 10.0, 1e-9);
  for (const std::size_t i : {0U, 1U, 3U, 4U, 5U}) {
    EXPECT_NEAR(inTool[i], 0.0, 1e-9);
    EXPECT_NEAR(inBase[i], 0.0, 1e-9);
  }
}

TEST_F(IiwaMessagesTest, TakesTheTorqueAboutTheAxisOfTheToolOrTheBase) {
  arm();
  // Fx Fy Fz τA τB τC: A is about z. The tool's z is the way of advancing, the base's is against
  // it.
  const auto inTool = wrenchInBytesFor(10.0, 1.25);
  EXPECT_NEAR(inTool[2], -10.0, 1e-9);
  EXPECT_NEAR(inTool[3], 1.25, 1e-9);
  EXPECT_NEAR(wrenchInBytesFor(0.0, -0.5)[3], -0.5, 1e-9);
  EXPECT_EQ(wrenchInBytesFor(10.0, 0.0)[3], 0.0);
  device_.reset();
  settings_.wrenchFrame = WrenchFrame::Base;
  settings_.port = tests::freePort();
  arm();
  const auto inBase = wrenchInBytesFor(10.0, 1.25);
  EXPECT_NEAR(inBase[3], -1.25, 1e-9);
  for (const std::size_t i : {0U, 1U, 4U, 5U}) {
    EXPECT_NEAR(inTool[i], 0.0, 1e-9);
    EXPECT_NEAR(inBase[i], 0.0, 1e-9);
  }
}

TEST_F(IiwaMessagesTest, MeasuresTheTurnAboutTheAxis) {
  arm();
  // The last joint's axis is the tool's, and so the way of advancing.
  (*message_.monitorData->measuredPosition)[6] += 0.005;
  EXPECT_NEAR(turn(0.0).turn, 0.005, 1e-9);
  (*message_.monitorData->measuredPosition)[6] -= 0.007;
  EXPECT_NEAR(turn(0.0).turn, -0.002, 1e-9);
}

TEST_F(IiwaMessagesTest, GivesTorquesThatAddUpToTheForceAndTheTorque) {
  settings_.overlay = IiwaOverlay::JointTorque;
  arm();
  turn(10.0, 1.5);
  const auto all = answers();
  ASSERT_EQ(all.size(), 1U);
  ASSERT_TRUE(all[0].data->jointTorque);
  EXPECT_FALSE(all[0].data->wrench);
  const IiwaKinematics kinematics(settings_.model, settings_.tool);
  Wrench wrench = Wrench::Zero();
  wrench.head<3>() = -10.0 * kDown;
  wrench.tail<3>() = 1.5 * kDown;
  const JointVector expected = kinematics.at(asVector(startOfArm())).jacobian.transpose() * wrench;
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_NEAR((*all[0].data->jointTorque)[i], expected[static_cast<Eigen::Index>(i)], 1e-9);
  }
}

TEST_F(IiwaMessagesTest, GetsNoForceWhileTheConnectionIsLessThanGood) {
  arm();
  for (const auto quality : {ConnectionQuality::Fair, ConnectionQuality::Poor}) {
    message_.connection->quality = quality;
    EXPECT_EQ(wrenchFor(10.0), Vector6{});
    message_.connection->quality = ConnectionQuality::Good;
    EXPECT_NEAR(wrenchFor(10.0)[2], -10.0, 1e-9);
  }
  EXPECT_EQ(device_->link().poorConnectionSamples, 2U);
  EXPECT_FALSE(isFaulted());
}

TEST_F(IiwaMessagesTest, EndsWhereTheConnectionStaysBad) {
  arm();
  message_.connection->quality = ConnectionQuality::Fair;
  for (int i = 0; i < 400 && !isFaulted(); ++i) {
    turn(10.0);
    timing::sleepUntil(soon(kMillisecond));
  }
  EXPECT_TRUE(says(device_->fault(), "has become worse than GOOD"));
}

TEST_F(IiwaMessagesTest, EndsWhereASafetyStopIsActive) {
  arm();
  message_.robotInfo->safetyState = SafetyState::StopLevel1;
  endsSaying("a safety stop of the robot is active");
}

TEST_F(IiwaMessagesTest, EndsWhereADriveIsOff) {
  arm();
  for (int i = 0; i < 7; ++i) {
    *message_.robotInfo->driveStates.add() = i == 4 ? DriveState::Off : DriveState::Active;
  }
  endsSaying("its drives are not active");
}

TEST_F(IiwaMessagesTest, EndsWhereItDoesNotSayWhereItsJointsAre) {
  arm();
  message_.monitorData->measuredPosition.reset();
  endsSaying("does not say where its joints are");
}

TEST_F(IiwaMessagesTest, EndsWhenTheRobotRestartsItsCounter) {
  next_ = 1000;
  arm();
  turn(0.0);
  answers();
  next_ = 0;
  endsSaying("has begun a new session");
}

TEST_F(IiwaMessagesTest, EndsWhereItCommandsNoMore) {
  arm();
  message_.connection->state = SessionState::CommandingWait;
  endsSaying("has stopped commanding");
}

TEST_F(IiwaMessagesTest, EndsNearTheEndOfAJoint) {
  arm();
  for (int i = 0; i < 2000 && !isFaulted(); ++i) {
    (*message_.monitorData->measuredPosition)[5] += 0.001;  // slowly
    turn(0.0);
  }
  EXPECT_TRUE(says(device_->fault(), "joint A6 is near its end"));
  EXPECT_NEAR(
      (*message_.monitorData->measuredPosition)[5],
      propertiesOf(settings_.model).maxPosition[5] - settings_.margins.position,
      0.002);
}

TEST_F(IiwaMessagesTest, EndsWhereAJointIsTooFast) {
  arm();
  for (int i = 0; i < 100 && !isFaulted(); ++i) {
    (*message_.monitorData->measuredPosition)[0] += 0.0065;  // 1.3 of 1.48 rad/s, in 5 ms
    turn(0.0);
  }
  EXPECT_TRUE(says(device_->fault(), "joint A1 is too fast"));
  armAgain();
  EXPECT_EQ(turn(0.0).status, DeviceStatus::Ok)
      << base::describe(device_->fault());  // and has come to rest
}

TEST_F(IiwaMessagesTest, EndsWhereAJointIsOverloaded) {
  arm();
  (*message_.monitorData->measuredTorque)[6] = -41.0;
  endsSaying("joint A7 is overloaded");
}

TEST_F(IiwaMessagesTest, ReportsTheVelocityOfItsTool) {
  arm();
  const IiwaKinematics kinematics(settings_.model, settings_.tool);
  JointVector velocity = JointVector::Zero();
  velocity[1] = 0.2;  // [rad/s]
  DeviceSample sample;
  JointVector joints(startOfArm().data());
  for (int i = 0; i < 60; ++i) {
    joints += 0.005 * velocity;
    std::copy_n(joints.data(), 7, message_.monitorData->measuredPosition->begin());
    sample = turn(0.0);
  }
  const double expected = kDown.dot((kinematics.at(joints).jacobian * velocity).head<3>());
  EXPECT_NEAR(sample.velocity, expected, 1e-6);
  const auto start = kinematics.at(asVector(startOfArm())).tool;
  EXPECT_NEAR(sample.travel, displacementAlong(kDown, start, kinematics.at(joints).tool), 1e-9);
}

TEST_F(IiwaMessagesTest, RefusesAPeriodOfAnswersBeyond32Bits) {
  device_ = std::make_unique<IiwaDevice>(settings_);
  message_.connection->sendPeriod = 5;
  message_.connection->receiveMultiplier = 858'993'460;  // 4 ms modulo 2³²
  EXPECT_TRUE(says(
      whyNot([this] { during([this] { device_->open(); }); }),
      "wants an answer every 4294967300 ms only: too slow to feel"));
}

TEST_F(IiwaMessagesTest, IsTheOnlySenderThatIsAccepted) {
  arm();
  DatagramSocket elsewhere(Endpoint{.address = endpointFrom("127.0.0.7")->address});
  DatagramSocket beside(Endpoint{});
  std::array<std::uint8_t, kLargestDatagram> bytes{};
  auto forged = makeMessage();
  forged.header.sequence = next_ + 5;
  (*forged.monitorData->measuredPosition)[1] += 1.0;
  const std::size_t count = encode(forged, settings_.version, bytes);
  for (auto* stranger : {&elsewhere, &beside}) {
    ASSERT_TRUE(stranger->send(std::span(bytes).first(count), client()));
  }
  const auto sample = turn(10.0);
  EXPECT_EQ(sample.status, DeviceStatus::Ok);
  EXPECT_NEAR(sample.travel, 0.0, 1e-9);
  EXPECT_EQ(device_->link().foreign, 2U);
  EXPECT_FALSE(elsewhere.receive(bytes));
  EXPECT_FALSE(beside.receive(bytes));
  EXPECT_EQ(answers().size(), 1U);
}

/// How many datagrams a device may take before it looks at the time.
constexpr std::uint64_t kMostAtOnce = 128;

void sendJunk(DatagramSocket& stranger, const Endpoint& to) {
  const std::array<std::uint8_t, 8> junk{};
  stranger.send(junk, to);
}

/// Counts are compared, and no times: a busy computer is slow without a flood, too.
TEST_F(IiwaMessagesTest, TakesABoundedNumberOfDatagramsOfAFloodAtOnce) {
  constexpr int kFlood = 10'000;
  arm();
  DatagramSocket stranger(Endpoint{});
  const auto flood = [&](const Endpoint& to) {
    for (int i = 0; i < kFlood; ++i) sendJunk(stranger, to);
  };
  // Control: what a flood leaves in a socket, as a loop without a bound would take it.
  DatagramSocket beside(Endpoint{});
  flood(beside.local());
  std::uint64_t waiting = 0;
  std::array<std::uint8_t, 8> bytes{};
  while (beside.receive(bytes)) ++waiting;
  if (waiting <= kMostAtOnce) GTEST_SKIP() << "a socket of this computer holds " << waiting;

  flood(client());
  const auto takenAtOnce = [&] {
    const auto before = device_->link().foreign;
    device_->pacer()->wait(timing::now());
    return device_->link().foreign - before;
  };
  EXPECT_EQ(takenAtOnce(), kMostAtOnce) << "of " << waiting;
  EXPECT_GT(takenAtOnce(), 0U) << "the rest is taken with the next message";
  say();
  EXPECT_EQ(tick(0.0).status, DeviceStatus::Ok) << base::describe(device_->fault());
}

TEST_F(IiwaMessagesTest, TakesABoundedNumberOfDatagramsWhileTheFloodGoesOn) {
  arm();
  const std::jthread flood([&](const std::stop_token& stop) {
    DatagramSocket stranger(Endpoint{});
    while (!stop.stop_requested()) sendJunk(stranger, client());
  });
  std::uint64_t before = device_->link().foreign;
  const std::uint64_t begin = before;
  for (int i = 0; i < 200 || before == begin; ++i) {
    device_->pacer()->wait(timing::now());
    const auto now = device_->link().foreign;
    EXPECT_LE(now - before, kMostAtOnce);
    before = now;
  }
}

TEST_F(IiwaMessagesTest, IsAnsweredForItsNewestMessageAfterADelay) {
  arm();
  const auto before = device_->link();  // on a busy machine some were skipped already
  for (int i = 0; i < 5; ++i) say();
  EXPECT_EQ(tick(10.0).status, DeviceStatus::Ok);
  const auto all = answers();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].header.reflected, next_ - 1);
  EXPECT_EQ(device_->link().skipped - before.skipped, 4U);
  EXPECT_EQ(device_->link().lost, 0U);
}

}  // namespace iiwa_messages_test
}  // namespace haptics::devices
