// An arm over FRI, against the emulated controller and against messages that a test makes.
//
// Periods of the controller go by when the test says so, and by its own clock, so that what is
// counted does not depend on how busy this computer is.
#include "haptics/devices/iiwa/iiwa_device.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <future>
#include <limits>
#include <memory>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "haptics/devices/device_error.h"
#include "haptics/emulators/fri_controller.h"
#include "haptics/timing/monotonic_clock.h"
#include "tests/support/allocation_counter.h"

namespace haptics::devices {
namespace iiwa_device_test {

using namespace haptics::wire::fri;
using emulators::FriController;
using emulators::FriReport;
using timing::kMillisecond;
using timing::kSecond;

constexpr int kAttempts = 3;  // where the computer may be too busy to be in time
constexpr int kPeriod = 2;    // [ms]

std::int64_t soon(std::int64_t time) {
  return timing::now() + time;
}

std::atomic<std::int64_t> controllerTime{kSecond};
std::int64_t controllerClock() noexcept {
  return controllerTime.load();
}

std::uint16_t freePort() {
  return DatagramSocket(Endpoint{}).local().port;
}

std::string whyNot(const std::function<void()>& action) {
  try {
    action();
  } catch (const DeviceError& error) {
    return error.what();
  }
  return {};
}

testing::AssertionResult says(const std::string& text, const std::string& words) {
  if (text.find(words) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << '"' << text << "\" does not say \"" << words << '"';
}

Joints startOfArm() {
  return emulators::FriArm::Options{}.start;
}

/// Down, as the emulated arm's tool points.
const Eigen::Vector3d kDown{0.0, 0.0, -1.0};

IiwaSettings settings(Version version = Version::V1_15, IiwaOverlay overlay = {}) {
  IiwaSettings made;
  made.port = freePort();
  made.version = version;
  made.overlay = overlay;
  made.tool.position.z() = 0.2;
  made.zero = startOfArm();
  return made;
}

FriController::Options controllerFor(const IiwaSettings& settings) {
  FriController::Options options;
  options.version = settings.version;
  options.client.port = settings.port;
  options.sendPeriod = kPeriod;
  options.stay = {.idle = 3, .monitoringReady = 5, .commandingWait = 3};
  options.queuesAgain = true;
  options.clock = controllerClock;
  options.arm.person = {.closed = 0.0, .stiffness = 2000.0, .damping = 60.0};
  if (settings.overlay == IiwaOverlay::JointTorque) {
    options.arm.control = ControlMode::JointImpedance;
    options.arm.command = ClientCommandMode::Torque;
  }
  return options;
}

/// A controller whose periods go by when the test says so, and the device that it speaks to.
class IiwaDeviceTest : public testing::Test {
 protected:
  void connect(const IiwaSettings& settings) { connect(settings, controllerFor(settings)); }
  void connect(const IiwaSettings& settings, const FriController::Options& options) {
    device_ = std::make_unique<IiwaDevice>(settings);
    controller_ = std::make_unique<FriController>(options);
  }

  FriReport report() const { return controller_->report(); }
  void order(const std::string& line) {
    const auto reply = controller_->command(line);
    EXPECT_TRUE(reply.isTaken) << reply.text;
  }

  void period() {
    controllerTime += controller_->options().sendPeriod * kMillisecond;
    controller_->step();
  }
  void hear() {
    while (controller_->receive(controllerClock())) {
    }
  }

  /// Lets the device do something that takes messages, and gives them as fast as they are answered.
  void during(const std::function<void()>& action) {
    auto done = std::async(std::launch::async, action);
    const auto isDone = [&] {
      return done.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    };
    while (!isDone()) {
      const auto answered = report().answers.taken;
      period();
      timing::sleepUntil(soon(kMillisecond / 4));
      const bool isDue = report().state != emulators::FriSession::State::Idle;
      const std::int64_t until = soon(50 * kMillisecond);
      while (isDue && report().answers.taken == answered && timing::now() < until && !isDone()) {
        controller_->receive(controllerClock() + kMillisecond);
      }
    }
    done.get();
  }
  void openAndArm() {
    during([this] { device_->open(); });
    during([this] { device_->arm(); });
    answer(0.0);  // what was left over
  }

  /// One period and the device's answer to it.
  DeviceSample turn(double force) {
    period();
    return answer(force);
  }
  DeviceSample answer(double force) {
    device_->beat()->wait(soon(kMillisecond));
    const auto sample = device_->read(0.001 * kPeriod);
    device_->command(force);
    hear();
    return sample;
  }
  void turns(double force, int count) {
    for (int i = 0; i < count; ++i) turn(force);
  }
  bool isFaulted() const { return device_->lifecycle() == Lifecycle::Faulted; }
  /// Ticks on until it is over; the last sample.
  DeviceSample turnUntilFault(double force) {
    DeviceSample sample;
    for (int i = 0; i < 1000 && !isFaulted(); ++i) sample = turn(force);
    EXPECT_TRUE(isFaulted());
    return sample;
  }
  /// At work.
  void work(double force, int count = 30) {
    openAndArm();
    turns(force, count);
    ASSERT_FALSE(isFaulted()) << device_->fault();
    ASSERT_NEAR(report().force, -force, 0.5);
  }

  std::unique_ptr<IiwaDevice> device_;
  std::unique_ptr<FriController> controller_;
};

struct Session {
  Version version;
  IiwaOverlay overlay;
};

class IiwaSessionTest : public IiwaDeviceTest, public testing::WithParamInterface<Session> {};

INSTANTIATE_TEST_SUITE_P(
    Sessions,
    IiwaSessionTest,
    testing::Values(
        Session{Version::V1_11, IiwaOverlay::CartesianWrench},
        Session{Version::V1_15, IiwaOverlay::CartesianWrench},
        Session{Version::V1_15, IiwaOverlay::JointTorque},
        Session{Version::V2_5, IiwaOverlay::CartesianWrench},
        Session{Version::V2_7, IiwaOverlay::CartesianWrench},
        Session{Version::V2_7, IiwaOverlay::JointTorque}),
    [](const auto& session) {
      std::string name = "Fri" + std::string(nameOf(session.param.version));
      std::replace(name.begin(), name.end(), '.', '_');
      return name + (session.param.overlay == IiwaOverlay::JointTorque ? "Torque" : "Wrench");
    });

TEST_P(IiwaSessionTest, ReachesCommandingAndGivesForceAgainstAdvancing) {
  connect(settings(GetParam().version, GetParam().overlay));
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Closed);
  during([this] { device_->open(); });
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Open);
  during([this] { device_->arm(); });
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Armed);
  EXPECT_EQ(report().state, SessionState::CommandingActive);
  for (const double force : {10.0, -4.0, 25.0}) {
    turns(force, 50);
    ASSERT_FALSE(isFaulted()) << device_->fault();
    EXPECT_NEAR(report().force, -force, 0.05);
  }
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Running);
  turns(0.0, 2);
  EXPECT_EQ(report().force, 0.0);
  EXPECT_EQ(report().lastEnd, emulators::FriEnd::None);
  EXPECT_LT(turn(0.0).travel, 0.0);  // and has been pushed back by it
}

TEST_P(IiwaSessionTest, KnowsTravelAsTheControllerDoes) {
  const auto mine = settings(GetParam().version, GetParam().overlay);
  auto options = controllerFor(mine);
  options.arm.person = {
      .closed = 0.03,
      .pauseTime = 0.0,
      .closeTime = 0.4,
      .openTime = 0.3,
      .stiffness = 2000.0,
      .damping = 60.0};
  connect(mine, options);
  openAndArm();
  double most = 0.0;
  for (int i = 0; i < 300; ++i) {
    const double travel = report().travel;  // of which the next message tells
    const auto sample = turn(5.0);
    ASSERT_EQ(sample.status, DeviceStatus::Ok) << device_->fault();
    ASSERT_NEAR(sample.travel, travel, 1e-6);
    most = std::max(most, sample.travel);
  }
  EXPECT_GT(most, 0.015);
}

TEST_F(IiwaDeviceTest, CountsTravelFromWhereItIsArmedUnlessToldOtherwise) {
  auto mine = settings();
  mine.zero.reset();
  auto options = controllerFor(mine);
  options.arm.start[1] += 0.2;
  connect(mine, options);
  openAndArm();
  EXPECT_NEAR(turn(0.0).travel, 0.0, 1e-4);
}

TEST_F(IiwaDeviceTest, SpeaksToTheRobotAtItsAddressWhereverThatIs) {
  auto mine = settings();
  mine.robot = "127.0.0.2";
  auto options = controllerFor(mine);
  options.local.address = endpointFrom("127.0.0.2")->address;
  connect(mine, options);
  work(10.0);
}

TEST_F(IiwaDeviceTest, AllocatesNothingInATick) {
  connect(settings());
  work(5.0);
  std::size_t count = 0;
  for (int i = 0; i < 100; ++i) {
    period();
    const tests::AllocationCounter allocations;
    answer(5.0);
    count += allocations.count();
  }
  EXPECT_EQ(count, 0U);
}

TEST_F(IiwaDeviceTest, CountsExactlyWhatWentWrongOnTheWay) {
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
  EXPECT_FALSE(isFaulted()) << device_->fault();
  const auto link = device_->link();
  EXPECT_EQ(link.lost, 3U + 3U + 2U + 2U);  // what cannot be read is not there
  EXPECT_EQ(link.doubled, 4U);
  EXPECT_EQ(link.late, 2U + 1U);
  EXPECT_EQ(link.damaged, 5U + 3U + 2U + 2U);
  EXPECT_EQ(link.foreign, 6U);
  EXPECT_EQ(link.restarts, 0U);
  const auto seen = report();
  EXPECT_EQ(seen.impostors, 6U);
  EXPECT_EQ(seen.misled, 0U);  // nobody else was ever answered
  EXPECT_EQ(seen.sixJoints + seen.notANumber, 4U);
  EXPECT_EQ(seen.answers.doubled + seen.answers.neverSent + seen.answers.undecodable, 0U);
  EXPECT_EQ(seen.lastEnd, emulators::FriEnd::None);
  EXPECT_NEAR(seen.force, -5.0, 1e-3);
}

TEST_F(IiwaDeviceTest, CountsGarbageWithoutAChecksumToo) {
  connect(settings(Version::V1_15));
  work(5.0, 5);
  order("garbage 50");
  turns(5.0, 60);
  EXPECT_EQ(device_->link().damaged, 50U);
  EXPECT_EQ(device_->link().lost, 0U);
  EXPECT_NEAR(report().force, -5.0, 1e-3);
}

TEST_F(IiwaDeviceTest, IsNeverMovedByAnImpostor) {
  const auto mine = settings();
  connect(mine);
  order("impostor 1000000");  // from the first message on
  work(5.0);
  turns(5.0, 50);
  const auto seen = report();
  EXPECT_GT(seen.impostors, 100U);
  EXPECT_EQ(seen.misled, 0U);
  EXPECT_GE(device_->link().foreign, 80U);
  EXPECT_EQ(device_->link().lost + device_->link().late, 0U);
  EXPECT_NEAR(seen.force, -5.0, 1e-3);
}

struct Spoiler {
  const char* name;
  const char* order;
  Version version;
};

class IiwaSpoiledTest : public IiwaDeviceTest, public testing::WithParamInterface<Spoiler> {};

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

TEST_P(IiwaSpoiledTest, IsNotActedUponAndEndsAsAFaultWhereItLasts) {
  connect(settings(GetParam().version));
  work(10.0);
  const auto before = report();
  const auto received = device_->link().received;
  order(GetParam().order);
  EXPECT_EQ(turnUntilFault(10.0).status, DeviceStatus::Gone);
  const auto seen = report();
  const auto spoiled = seen.sixJoints + seen.notANumber + seen.wrongVersion;
  EXPECT_EQ(device_->link().damaged, spoiled);
  EXPECT_EQ(device_->link().received, received);
  EXPECT_LE(seen.answers.taken, before.answers.taken);
  EXPECT_TRUE(says(device_->fault(), "has missed 20 cycles"));
  for (int i = 0; i < 10; ++i) period();
  EXPECT_EQ(report().force, 0.0);
}

TEST_F(IiwaDeviceTest, RefusesAnotherVersionInWords) {
  connect(settings(Version::V2_7));
  order("wrong-version");
  EXPECT_TRUE(says(whyNot([&] { during([this] { device_->open(); }); }), "cannot be read as FRI"));
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Closed);
}

class IiwaStallTest : public IiwaDeviceTest, public testing::WithParamInterface<Session> {};

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
  EXPECT_EQ(turnUntilFault(10.0).status, DeviceStatus::Gone);
  EXPECT_TRUE(says(device_->fault(), "has missed 20 cycles, or been silent for 50 ms"));
  for (int i = 0; i < 10; ++i) period();
  const auto seen = report();
  EXPECT_GT(seen.stalled, 0U);
  EXPECT_EQ(seen.force, 0.0);
  EXPECT_FALSE(seen.hasOverlay);
  EXPECT_GT(seen.zeroAt, begin);
  EXPECT_LE(seen.zeroAt - begin, 50 * kMillisecond);
  EXPECT_EQ(turn(10.0).status, DeviceStatus::Gone);
}

TEST_F(IiwaDeviceTest, BridgesAShortStall) {
  connect(settings());
  work(10.0);
  order("stall 8");
  const auto before = device_->link().stale;
  int stale = 0;
  for (int i = 0; i < 20; ++i) stale += turn(10.0).status == DeviceStatus::Stale ? 1 : 0;
  EXPECT_EQ(stale, 4);
  EXPECT_EQ(device_->link().stale, before + 4);
  EXPECT_FALSE(isFaulted()) << device_->fault();
  EXPECT_NEAR(report().force, -10.0, 1e-3);
}

TEST_F(IiwaDeviceTest, LetsGoWhereTheConnectionIsPoor) {
  connect(settings());
  work(10.0);
  order("quality poor");
  EXPECT_NE(turn(10.0).status, DeviceStatus::Ok);
  EXPECT_EQ(report().force, 0.0);
  turnUntilFault(10.0);
  EXPECT_EQ(report().force, 0.0);
}

TEST_F(IiwaDeviceTest, EndsWithASafetyStop) {
  connect(settings());
  work(10.0);
  order("safety-stop");
  EXPECT_EQ(turn(10.0).status, DeviceStatus::Faulted);
  EXPECT_TRUE(isFaulted());
  EXPECT_TRUE(says(device_->fault(), "SmartPad")) << device_->fault();
  EXPECT_EQ(report().force, 0.0);
}

TEST_F(IiwaDeviceTest, EndsWithARestartOfTheController) {
  connect(settings());
  work(10.0);
  order("restart");
  EXPECT_EQ(turn(10.0).status, DeviceStatus::Faulted);
  EXPECT_NE(device_->fault(), "");
  EXPECT_EQ(report().force, 0.0);
}

TEST_F(IiwaDeviceTest, EndsWithTheSession) {
  connect(settings());
  work(10.0);
  order("idle");
  EXPECT_EQ(turn(10.0).status, DeviceStatus::Faulted);
  EXPECT_TRUE(says(device_->fault(), "has stopped commanding"));
}

TEST_F(IiwaDeviceTest, IsConnectedAnewAfterEveryFault) {
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
  EXPECT_EQ(device_->fault(), "");
}

TEST_F(IiwaDeviceTest, MakesNoForceAfterItIsDisarmed) {
  connect(settings());
  work(10.0);
  device_->disarm();
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Open);
  device_->command(10.0);
  during([] { timing::sleepUntil(soon(20 * kMillisecond)); });
  EXPECT_EQ(report().force, 0.0);
  EXPECT_EQ(report().state, SessionState::CommandingActive);
  during([this] { device_->arm(); });
  turns(10.0, 5);
  EXPECT_NEAR(report().force, -10.0, 1e-3);
}

TEST_F(IiwaDeviceTest, ClipsAForceThatItDoesNotGiveAndCountsIt) {
  auto mine = settings();
  mine.maxForce = 20.0;
  connect(mine);
  work(10.0);
  const auto before = device_->link().clipped;
  turns(30.0, 10);
  EXPECT_EQ(device_->link().clipped, before + 10);
  EXPECT_NEAR(report().force, -20.0, 1e-3);
  turns(20.0, 10);
  EXPECT_EQ(device_->link().clipped, before + 10);
  turns(std::nan(""), 2);
  EXPECT_EQ(report().force, 0.0);
  EXPECT_EQ(device_->link().clipped, before + 12);
}

TEST_F(IiwaDeviceTest, GivesNoMoreThanTheGuardAllows) {
  auto mine = settings(Version::V1_15, IiwaOverlay::JointTorque);
  mine.margins.torque = 0.01;  // 3.2 N·m in A2
  connect(mine);
  openAndArm();
  turns(100.0, 30);
  EXPECT_LT(report().force, 0.0);
  EXPECT_GT(report().force, -15.0);
  EXPECT_GT(device_->link().clipped, 25U);
}

TEST_F(IiwaDeviceTest, SaysInWordsWhyItCannotBeOpened) {
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

TEST_F(IiwaDeviceTest, DoesNotListenToAnotherAddress) {
  auto mine = settings();
  mine.robot = "127.0.0.9";
  connect(mine);
  EXPECT_TRUE(says(whyNot([&] { during([this] { device_->open(); }); }), "but 127.0.0.1 does ("));
  EXPECT_EQ(report().answers.taken, 0U);
}

// Whether it is fit for use.

const CheckResult* lineOf(const std::vector<CheckResult>& found, const std::string& what) {
  const auto line = std::find_if(
      found.begin(), found.end(), [&](const CheckResult& result) { return result.what == what; });
  return line == found.end() ? nullptr : &*line;
}

TEST_F(IiwaDeviceTest, IsFoundFit) {
  connect(settings());
  std::vector<CheckResult> found;
  during([&] { found = device_->check(0.2); });
  for (const auto& line : found) {
    EXPECT_NE(line.finding, Finding::Fail) << line.what << ": " << line.measured;
  }
  for (const char* what : {"connection", "session", "force overlay", "safety state", "joints"}) {
    ASSERT_NE(lineOf(found, what), nullptr) << what;
    EXPECT_EQ(lineOf(found, what)->finding, Finding::Pass) << what;
  }
  EXPECT_EQ(lineOf(found, "session")->measured, "COMMANDING_ACTIVE, connection EXCELLENT");
  EXPECT_EQ(
      lineOf(found, "messages lost, doubled, late, damaged, foreign")->measured, "0, 0, 0, 0, 0");
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Checked);
  during([this] { device_->arm(); });
  turns(10.0, 5);
  EXPECT_NEAR(report().force, -10.0, 1e-3);
}

TEST_F(IiwaDeviceTest, IsFoundUnfitInAnotherModeThanTheRobots) {
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

TEST_F(IiwaDeviceTest, IsToldWhichOverlayTheRobotTakes) {
  auto mine = settings();
  const auto options = controllerFor(mine);
  mine.overlay = IiwaOverlay::JointTorque;
  connect(mine, options);
  std::vector<CheckResult> found;
  during([&] { found = device_->check(0.2); });
  ASSERT_NE(lineOf(found, "force overlay"), nullptr);
  EXPECT_EQ(lineOf(found, "force overlay")->finding, Finding::Fail);
  EXPECT_TRUE(says(lineOf(found, "force overlay")->mend, R"("overlay": "wrench")"));
}

TEST_F(IiwaDeviceTest, IsFoundUnfitWhenItFallsSilent) {
  connect(settings());
  during([&] { device_->open(); });
  const auto found = device_->check(0.2);  // and no period goes by
  ASSERT_NE(lineOf(found, "longest silence"), nullptr);
  EXPECT_EQ(lineOf(found, "longest silence")->finding, Finding::Fail);
  EXPECT_TRUE(says(lineOf(found, "longest silence")->measured, "nothing has come from the arm"));
  EXPECT_NE(device_->lifecycle(), Lifecycle::Checked);
}

TEST_F(IiwaDeviceTest, IsFoundUnfitWhereItHadBeenSilentForLong) {
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

TEST_F(IiwaDeviceTest, SaysWhoElseSends) {
  auto mine = settings();
  const auto options = controllerFor(mine);
  mine.robot = "192.0.2.147";  // an address for documentation: nobody has it
  connect(mine, options);
  const auto why = whyNot([&] { during([this] { device_->open(); }); });
  EXPECT_TRUE(says(why, "sends nothing to UDP port " + std::to_string(mine.port)));
  EXPECT_TRUE(says(why, "127.0.0.1 does ("));
  EXPECT_TRUE(says(why, R"("robot_address": "127.0.0.1")"));
}

TEST_F(IiwaDeviceTest, IsFoundUnfitWhereItsPortCannotBeHad) {
  const auto mine = settings();
  const DatagramSocket other(Endpoint{.port = mine.port});
  IiwaDevice device(mine);
  const auto found = device.check(0.1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].finding, Finding::Fail);
  EXPECT_TRUE(says(found[0].mend, "cannot be had"));
}

// In real time, with a controller that goes on by itself.

TEST_F(IiwaDeviceTest, WorksInRealTimeAndLetsGoInTime) {
  std::int64_t after = 0;
  bool hasPushed = false;
  for (int i = 0; i < kAttempts && !(after > 0 && after <= 50 * kMillisecond); ++i) {
    auto mine = settings();
    auto options = controllerFor(mine);
    options.sendPeriod = 4;
    options.clock = emulators::monotonicTime;
    connect(mine, options);
    const std::jthread running([&](const std::stop_token& stop) { controller_->run(stop); });
    if (!whyNot([&] {
           device_->open();
           device_->arm();
         }).empty()) {
      continue;  // the computer was too busy
    }
    const auto tick = [&](double force) {
      device_->beat()->wait(soon(10 * kMillisecond));
      device_->read(0.004);
      device_->command(force);
    };
    for (int k = 0; k < 50; ++k) tick(10.0);
    hasPushed = hasPushed || std::abs(report().force + 10.0) < 0.01;
    if (isFaulted()) continue;
    const std::int64_t begin = timing::now();
    order("stall 500");
    const std::int64_t until = soon(2 * kSecond);
    while ((!isFaulted() || report().hasOverlay) && timing::now() < until) tick(10.0);
    EXPECT_TRUE(isFaulted());
    after = report().zeroAt - begin;
  }
  EXPECT_TRUE(hasPushed);
  EXPECT_GT(after, 0);
  EXPECT_LE(after, 50 * kMillisecond);
}

/// A robot that says whatever a test wants, and hears what it is answered.
class MadeRobotTest : public testing::Test {
 protected:
  MadeRobotTest() { message_ = makeMessage(); }

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
  DeviceSample tick(double force) {
    device_->beat()->wait(soon(kMillisecond));
    const auto sample = device_->read(0.005);
    device_->command(force);
    return sample;
  }
  DeviceSample turn(double force) {
    say();
    return tick(force);
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

TEST_F(MadeRobotTest, IsAnsweredOnceAndWithItsOwnJoints) {
  arm();
  (*message_.ipoData->jointPosition)[3] += 0.001;
  turn(10.0);
  device_->command(10.0);
  tick(10.0);
  const auto all = answers();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].header.reflected, next_ - 1);
  EXPECT_EQ(all[0].data->jointPosition, message_.ipoData->jointPosition);
  EXPECT_FALSE(all[0].data->jointTorque);
}

TEST_F(MadeRobotTest, IsAnsweredAsOftenAsItWants) {
  message_.connection->receiveMultiplier = 3;
  arm();
  for (int i = 0; i < 30; ++i) turn(10.0);
  EXPECT_EQ(answers().size(), 10U);
}

TEST_F(MadeRobotTest, TakesTheForceInTheAxesOfTheToolOrTheBase) {
  arm();
  const auto inTool = wrenchFor(10.0);
  EXPECT_NEAR(inTool[2], -10.0, 1e-9);  // the tool's z points down, as the axis does
  device_.reset();
  settings_.wrenchFrame = WrenchFrame::Base;
  settings_.port = freePort();
  arm();
  const auto inBase = wrenchFor(10.0);
  EXPECT_NEAR(inBase[2], 10.0, 1e-9);
  for (const std::size_t i : {0U, 1U, 3U, 4U, 5U}) {
    EXPECT_NEAR(inTool[i], 0.0, 1e-9);
    EXPECT_NEAR(inBase[i], 0.0, 1e-9);
  }
}

TEST_F(MadeRobotTest, GivesTorquesThatAddUpToTheForce) {
  settings_.overlay = IiwaOverlay::JointTorque;
  arm();
  turn(10.0);
  const auto all = answers();
  ASSERT_EQ(all.size(), 1U);
  ASSERT_TRUE(all[0].data->jointTorque);
  EXPECT_FALSE(all[0].data->wrench);
  const IiwaKinematics kinematics(settings_.model, settings_.tool);
  Wrench wrench = Wrench::Zero();
  wrench.head<3>() = -10.0 * kDown;
  const JointVector expected = kinematics.torque(JointVector(startOfArm().data()), wrench);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_NEAR((*all[0].data->jointTorque)[i], expected[static_cast<Eigen::Index>(i)], 1e-9);
  }
}

TEST_F(MadeRobotTest, GetsNoForceWhileTheConnectionIsLessThanGood) {
  arm();
  for (const auto quality : {ConnectionQuality::Fair, ConnectionQuality::Poor}) {
    message_.connection->quality = quality;
    EXPECT_EQ(wrenchFor(10.0), Vector6{});
    message_.connection->quality = ConnectionQuality::Good;
    EXPECT_NEAR(wrenchFor(10.0)[2], -10.0, 1e-9);
  }
  EXPECT_EQ(device_->link().poor, 2U);
  EXPECT_FALSE(isFaulted());
}

TEST_F(MadeRobotTest, EndsWhereTheConnectionStaysBad) {
  arm();
  message_.connection->quality = ConnectionQuality::Fair;
  for (int i = 0; i < 400 && !isFaulted(); ++i) {
    turn(10.0);
    timing::sleepUntil(soon(kMillisecond));
  }
  EXPECT_TRUE(says(device_->fault(), "has become worse than GOOD"));
}

TEST_F(MadeRobotTest, EndsWhereASafetyStopIsActive) {
  arm();
  message_.robotInfo->safetyState = SafetyState::StopLevel1;
  endsSaying("a safety stop of the robot is active");
}

TEST_F(MadeRobotTest, EndsWhereADriveIsOff) {
  arm();
  for (int i = 0; i < 7; ++i) {
    *message_.robotInfo->driveStates.add() = i == 4 ? DriveState::Off : DriveState::Active;
  }
  endsSaying("its drives are not active");
}

TEST_F(MadeRobotTest, EndsWhereItDoesNotSayWhereItsJointsAre) {
  arm();
  message_.monitorData->measuredPosition.reset();
  endsSaying("does not say where its joints are");
}

TEST_F(MadeRobotTest, EndsWhereItBeginsToCountAnew) {
  next_ = 1000;
  arm();
  turn(0.0);
  answers();
  next_ = 0;
  endsSaying("has begun a new session");
}

TEST_F(MadeRobotTest, EndsWhereItCommandsNoMore) {
  arm();
  message_.connection->state = SessionState::CommandingWait;
  endsSaying("has stopped commanding");
}

TEST_F(MadeRobotTest, EndsNearTheEndOfAJoint) {
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

TEST_F(MadeRobotTest, EndsWhereAJointIsTooFast) {
  arm();
  for (int i = 0; i < 100 && !isFaulted(); ++i) {
    (*message_.monitorData->measuredPosition)[0] += 0.0065;  // 1.3 of 1.48 rad/s, in 5 ms
    turn(0.0);
  }
  EXPECT_TRUE(says(device_->fault(), "joint A1 is too fast"));
  armAgain();
  EXPECT_EQ(turn(0.0).status, DeviceStatus::Ok) << device_->fault();  // and has come to rest
}

TEST_F(MadeRobotTest, EndsWhereAJointIsOverloaded) {
  arm();
  (*message_.monitorData->measuredTorque)[6] = -41.0;
  endsSaying("joint A7 is overloaded");
}

TEST_F(MadeRobotTest, TellsHowFastItsToolMoves) {
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
  const double expected = kDown.dot(kinematics.twist(joints, velocity).head<3>());
  EXPECT_NEAR(sample.velocity, expected, 1e-6);
  const auto start = kinematics.tool(JointVector(startOfArm().data()));
  EXPECT_NEAR(sample.travel, displacementAlong(kDown, start, kinematics.tool(joints)), 1e-9);
}

TEST_F(MadeRobotTest, IsTheOnlyOneThatIsHeard) {
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

TEST_F(MadeRobotTest, IsAnsweredInTimeWhileSomebodyFloodsTheLine) {
  arm();
  const std::jthread flood([&](const std::stop_token& stop) {
    DatagramSocket stranger(Endpoint{});
    const std::array<std::uint8_t, 8> junk{};
    while (!stop.stop_requested()) stranger.send(junk, client());
  });
  const std::int64_t begin = timing::now();
  for (int i = 0; i < 20; ++i) device_->beat()->wait(soon(kMillisecond));
  EXPECT_LT(timing::now() - begin, 4 * kSecond);  // it comes back at all
}

TEST_F(MadeRobotTest, IsTakenOverByTheNewestWhereWeWereLate) {
  arm();
  for (int i = 0; i < 5; ++i) say();
  EXPECT_EQ(tick(10.0).status, DeviceStatus::Ok);
  const auto all = answers();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].header.reflected, next_ - 1);
  EXPECT_EQ(device_->link().skipped, 4U);
  EXPECT_EQ(device_->link().lost, 0U);
}

}  // namespace iiwa_device_test
}  // namespace haptics::devices
