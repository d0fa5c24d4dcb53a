// The punch's host against its emulator: the firmware's own program behind a pseudo-terminal.
//
// A device is given up after 50 ms of silence, and a computer may be too busy for that: what is
// disturbed so is tried again.
#include "haptics/devices/punch/punch_device.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include <gtest/gtest.h>

#include "haptics/devices/device_error.h"
#include "haptics/devices/punch/firmware_build.h"
#include "haptics/emulators/punch_emulator.h"
#include "haptics/recordings/parametric_cut.h"
#include "haptics/timing/urgency.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/scratch_folder.h"

namespace haptics::devices {
namespace punch_device_test {

using emulators::Fault;
using emulators::PunchEmulator;
using timing::kMillisecond;
using timing::kSecond;

constexpr double kNewtonsPerVolt = 0.667;
constexpr double kTravelPerCount = 0.00439;
constexpr std::int64_t kPatience = 8 * kSecond;  // for what has to be tried again

std::int64_t soon(std::int64_t time) {
  return timing::now() + time;
}

/// An emulated punch that goes on by itself, a thousand times a second, or turn by turn.
class Board {
 public:
  explicit Board(const PunchEmulator::Options& options = {}) : emulator_(options) { goOn(); }

  const std::string& port() const { return emulator_.port(); }

  void goOn() {
    thread_ = std::jthread([this](const std::stop_token& stop) {
      timing::makeUrgent(timing::kStandInUrgency);
      std::int64_t due = timing::now();
      while (!stop.stop_requested()) {
        step();
        due = std::max(due + kMillisecond, timing::now() - 5 * kMillisecond);
        timing::sleepUntil(due);
      }
    });
  }
  void hold() { thread_ = {}; }
  void step() {
    const std::scoped_lock lock(gate_);
    emulator_.step();
  }

  void order(std::string_view line) {
    const std::scoped_lock lock(gate_);
    EXPECT_EQ(emulator_.command(line), "");
  }
  template <typename Question>
  auto ask(const Question& question) const {
    const std::scoped_lock lock(gate_);
    return question(emulator_);
  }
  double force() const {
    return ask([](const auto& e) { return e.force(); });
  }
  double travel() const {
    return ask([](const auto& e) { return e.travel(); });
  }
  std::uint64_t injected(Fault fault) const {
    return ask([&](const auto& e) { return e.injected()[fault]; });
  }
  bool isArmed() const {
    return ask([](const auto& e) { return e.status().find("armed=1") != std::string::npos; });
  }

 private:
  PunchEmulator emulator_;
  mutable std::mutex gate_;
  std::jthread thread_;
};

/// A hand that rests.
PunchEmulator::Options atRest() {
  return {.person = {.closed = 0.0}};
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

class PunchDeviceTest : public testing::Test {
 protected:
  PunchSettings settings(const std::string& port) {
    return {.port = port, .travelPerCount = kTravelPerCount, .newtonsPerVolt = kNewtonsPerVolt};
  }
  void connect(PunchEmulator::Options options) {
    options.newtonsPerVolt = kNewtonsPerVolt;
    options.travelPerCount = kTravelPerCount;
    options.link = folder_ / "punch";
    options.limits.silence = 5000;  // the board forgives a computer that is busy
    board_.emplace(options);
    device_ = std::make_unique<PunchDevice>(settings(board_->port()));
  }

  /// One exchange, while the board goes on by itself.
  DeviceSample exchange(double force) {
    device_->beat()->wait(soon(2 * kMillisecond));
    const auto sample = device_->read(0.001);
    device_->command(force);
    return sample;
  }
  /// One exchange, and the board waits for it.
  DeviceSample turn(double force) {
    board_->step();
    return exchange(force);
  }
  void openAndHold() {
    device_->open();
    device_->arm();
    board_->hold();
    for (int i = 0; i < 10; ++i) turn(0.0);
  }
  bool exchangeUntil(double force, const std::function<bool(const DeviceSample&)>& isDone) {
    const std::int64_t until = soon(3 * kSecond);
    while (timing::now() < until) {
      if (isDone(exchange(force))) return true;
    }
    return false;
  }
  /// Open, armed for longer than old faults are forgiven, and pushing back.
  bool push(double force) {
    const std::int64_t until = soon(kPatience);
    while (timing::now() < until) {
      device_->open();
      device_->arm();
      const std::int64_t settled = soon(100 * kMillisecond);
      const bool isPushing = exchangeUntil(force, [&](const DeviceSample&) {
        return isFaulted() ||
               (timing::now() > settled && std::abs(board_->force() - force) < 0.001);
      });
      if (isPushing && !isFaulted()) return true;
    }
    return false;
  }
  bool isFaulted() const { return device_->lifecycle() == Lifecycle::Faulted; }
  bool waitUntil(const std::function<bool()>& isDone) {
    const std::int64_t until = soon(3 * kSecond);
    while (!isDone() && timing::now() < until) timing::sleepUntil(soon(kMillisecond));
    return isDone();
  }

  /// Orders what ends a trial, and ticks on until it is over, for the reason that is expected.
  testing::AssertionResult endsBy(const char* order, const std::string& words) {
    testing::AssertionResult result = testing::AssertionFailure() << "never pushed back";
    const std::int64_t until = soon(kPatience);
    while (!result && timing::now() < until && push(4.0)) {
      board_->order(order);
      if (!exchangeUntil(4.0, [&](const DeviceSample&) { return isFaulted(); })) break;
      result = says(device_->fault(), words);
      if (!result) board_->order("mend");
    }
    return result;
  }

  const tests::ScratchFolder folder_;
  std::optional<Board> board_;
  std::unique_ptr<PunchDevice> device_;
};

TEST_F(PunchDeviceTest, ExchangesAThousandSamplesAtTheBoardsOwnPace) {
  connect({});
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Closed);
  device_->open();
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Open);
  EXPECT_EQ(device_->hello().build, kFirmwareBuild);
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
  EXPECT_TRUE(link.isThere);
  EXPECT_GE(received + link.received, 1000U);
  EXPECT_EQ(link.lost + link.doubled + link.late + link.damaged + link.restarts, 0U);
  EXPECT_GT(link.roundTrip.count(), 0U);
  device_->disarm();
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Open);
  EXPECT_TRUE(waitUntil([&] { return !board_->isArmed(); }));
  EXPECT_EQ(device_->fault(), "");
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

TEST_F(PunchDeviceTest, KnowsTravelAsItWasCalibrated) {
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

TEST_F(PunchDeviceTest, PushesNobodyWithWhatIsNoNumber) {
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
  emulators::Injected before;
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
  EXPECT_FALSE(isFaulted()) << device_->fault();
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

TEST_F(PunchDeviceTest, TravelsBackNoWayForAFrameThatCameLate) {
  connect({});
  openAndHold();
  board_->order("reorder 100");
  std::int64_t before = 0;
  for (int i = 0; i < 600 && !isFaulted(); ++i) {
    const auto sample = turn(1.0);
    if (sample.status == DeviceStatus::Gone) break;
    EXPECT_GE(sample.deviceTime, before);
    before = sample.deviceTime;
  }
  EXPECT_GT(board_->injected(Fault::Reorder), 0U);
}

TEST_F(PunchDeviceTest, SaysInWordsWhyItCannotBeOpened) {
  EXPECT_TRUE(
      says(whyNot([&] { PunchDevice(settings(folder_ / "nobody")).open(); }), "no serial port"));
  const auto file = folder_.write("file", "no line");
  EXPECT_TRUE(says(whyNot([&] { PunchDevice(settings(file)).open(); }), "is no serial port"));
  emulators::PseudoTerminal nobody;
  EXPECT_TRUE(
      says(whyNot([&] { PunchDevice(settings(nobody.port())).open(); }), "does not answer"));
  auto odd = settings(nobody.port());
  odd.baud = 12345;
  EXPECT_TRUE(says(whyNot([&] { PunchDevice(odd).open(); }), "12345 baud"));
}

TEST_F(PunchDeviceTest, RefusesAnotherFirmware) {
  auto options = atRest();
  options.limits.build = 0xABCDEF;
  connect(options);
  EXPECT_TRUE(says(whyNot([&] { device_->open(); }), "runs firmware 0000000000abcdef"));
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Closed);
  auto meant = settings(board_->port());
  meant.build = 0xABCDEF;
  PunchDevice device(meant);
  EXPECT_EQ(whyNot([&] { device.open(); }), "");
}

TEST_F(PunchDeviceTest, RefusesAnotherBoard) {
  auto options = atRest();
  options.limits.serial = 12;
  connect(options);
  auto other = settings(board_->port());
  other.serial = 13;
  EXPECT_TRUE(says(whyNot([&] { PunchDevice(other).open(); }), "is board 12, and board 13"));
  other.serial = 12;
  EXPECT_EQ(whyNot([&] { PunchDevice(other).open(); }), "");
}

/// Answers everything with one and the same greeting.
class Stranger {
 public:
  explicit Stranger(const wire::punch::Hello& hello)
      : thread_([this, hello](const std::stop_token& stop) {
          std::array<std::uint8_t, 256> heard{};
          std::array<std::uint8_t, wire::punch::kLargestOnWire> bytes{};
          const auto count = wire::punch::encode(hello, 0, 0, bytes.data());
          while (!stop.stop_requested()) {
            if (line_.read(heard) > 0) line_.write(std::span(bytes).first(count));
            timing::sleepUntil(soon(kMillisecond));
          }
        }) {}
  const std::string& port() const { return line_.port(); }

 private:
  emulators::PseudoTerminal line_;
  std::jthread thread_;
};

TEST_F(PunchDeviceTest, RefusesAnotherProtocol) {
  const Stranger newer({.protocolVersion = 9, .build = kFirmwareBuild, .rate = 1000});
  EXPECT_TRUE(says(
      whyNot([&] { PunchDevice(settings(newer.port())).open(); }), "version 9 of the protocol"));
}

TEST_F(PunchDeviceTest, RefusesABoardThatCannotBe) {
  const Stranger broken({.build = kFirmwareBuild, .rate = 1});
  EXPECT_TRUE(says(whyNot([&] { PunchDevice(settings(broken.port())).open(); }), "what cannot be"));
}

TEST_F(PunchDeviceTest, LeavesALineToWhoHasItAlready) {
  connect(atRest());
  device_->open();
  PunchDevice second(settings(board_->port()));
  EXPECT_TRUE(says(whyNot([&] { second.open(); }), "in use by another program"));
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Open);
  device_->close();
  EXPECT_EQ(whyNot([&] { second.open(); }), "");
}

TEST_F(PunchDeviceTest, RestsWhileNobodyTicks) {
  connect(atRest());
  device_->open();
  rusage before{};
  rusage after{};
  getrusage(RUSAGE_SELF, &before);
  timing::sleepUntil(soon(500 * kMillisecond));
  getrusage(RUSAGE_SELF, &after);
  const auto used = [](const rusage& usage) {
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
  };
  EXPECT_LT(used(after) - used(before), 0.25);
}

TEST_F(PunchDeviceTest, TakesNoForceUnlessArmed) {
  connect(atRest());
  EXPECT_TRUE(says(whyNot([&] { device_->arm(); }), "is not ready"));
  device_->command(5.0);
  EXPECT_EQ(device_->read(0.001).status, DeviceStatus::Gone);
}

TEST_F(PunchDeviceTest, LetsGoWithinFiftyMillisecondsWhenItIsUnplugged) {
  connect(atRest());
  std::optional<double> after;
  for (int i = 0; i < 3 && !(after && *after < 50.0); ++i) {
    ASSERT_TRUE(push(4.0));
    board_->order("unplug");
    ASSERT_TRUE(exchangeUntil(
        4.0, [&](const DeviceSample& sample) { return sample.status == DeviceStatus::Gone; }));
    EXPECT_EQ(device_->lifecycle(), Lifecycle::Faulted);
    ASSERT_TRUE(waitUntil([&] { return board_->force() == 0.0; }));
    after = board_->ask([](const auto& e) { return e.letGoAfter(); });
    EXPECT_TRUE(says(whyNot([&] { device_->arm(); }), device_->fault()));
    EXPECT_TRUE(says(whyNot([&] { device_->open(); }), "no serial port"));
    board_->order("plug");
  }
  ASSERT_TRUE(after);
  EXPECT_LT(*after, 50.0);
}

TEST_F(PunchDeviceTest, IsConnectedAnewAfterItWasUnplugged) {
  connect(atRest());
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(endsBy("unplug", "unplugged"));
    device_->disarm();
    board_->order("plug");
  }
  EXPECT_TRUE(push(4.0));
  EXPECT_EQ(device_->fault(), "");
}

TEST_F(PunchDeviceTest, NoticesAPlugThatIsPulledWhileNobodyTicks) {
  connect(atRest());
  device_->open();
  board_->order("unplug");
  EXPECT_TRUE(waitUntil([&] { return isFaulted(); }));
  EXPECT_NE(device_->fault(), "");
}

TEST_F(PunchDeviceTest, GivesUpABoardThatFallsSilent) {
  connect(atRest());
  ASSERT_TRUE(push(4.0));
  const std::int64_t muted = timing::now();
  board_->order("mute 200");
  EXPECT_TRUE(exchangeUntil(4.0, [&](const DeviceSample&) { return isFaulted(); }));
  EXPECT_GT(timing::now() - muted, 45 * kMillisecond);
  EXPECT_TRUE(says(device_->fault(), "has sent nothing for 50 ms"));
  EXPECT_EQ(exchange(4.0).status, DeviceStatus::Gone);
  EXPECT_TRUE(waitUntil([&] { return board_->force() == 0.0; }));
  EXPECT_FALSE(board_->isArmed());
}

TEST_F(PunchDeviceTest, GivesUpABoardThatHasBeenReset) {
  connect(atRest());
  EXPECT_TRUE(endsBy("reset", "has sent nothing for 50 ms"));
  EXPECT_EQ(board_->force(), 0.0);
  EXPECT_TRUE(push(4.0));  // after open() it is as good as new
}

TEST_F(PunchDeviceTest, GivesUpABoardThatHangsAndItsWatchdogLetsGo) {
  connect(atRest());
  EXPECT_TRUE(endsBy("stall 300", "has sent nothing for 50 ms"));
  EXPECT_TRUE(waitUntil([&] { return board_->force() == 0.0; }));
  EXPECT_TRUE(waitUntil([&] { return whyNot([&] { device_->open(); }).empty(); }));
}

TEST_F(PunchDeviceTest, SaysWhatTheBoardFoundBroken) {
  connect(atRest());
  EXPECT_TRUE(endsBy("leap 5000", "its encoder jumps"));
  board_->order("mend");
  EXPECT_TRUE(endsBy("driver-fault", "the motor's driver reports a fault"));
  EXPECT_TRUE(waitUntil([&] { return board_->force() == 0.0; }));
  board_->order("mend");
  EXPECT_TRUE(push(4.0));
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

// Rendered by the board itself.

engine::InterpolationSpec recordedCut() {
  engine::InterpolationSpec spec;
  const auto cut = recordings::parametricCut();
  for (const auto& node : cut.curve.nodes()) spec.curve.push_back({node.travel, node.force});
  return spec;
}

TEST_F(PunchDeviceTest, LetsTheBoardRenderAsTheEngineWould) {
  connect({});
  device_->open();
  const engine::FiniteElementsSpec spec;
  device_->renderOnDevice({.model = spec}, 7.5);
  device_->arm();
  board_->hold();
  const models::FiniteElements<double> elements(spec.parameters);
  models::FiniteElements<double>::State state;
  double most = 0.0;
  int settled = 20;
  std::int64_t last = timing::now();
  for (int i = 0; i < 1400; ++i) {
    const auto sample = turn(7.5);  // as much as the board may give
    timing::sleepUntil(soon(kMillisecond / 2));
    ASSERT_FALSE(isFaulted()) << device_->fault();
    // Where we were late the board has let go, and comes back as fast as it may.
    if (timing::now() - std::exchange(last, timing::now()) > 5 * kMillisecond) settled = i + 20;
    if (i < settled || sample.status != DeviceStatus::Ok) continue;
    const double counts = std::round(board_->travel() / kTravelPerCount);
    const double expected =
        std::clamp(elements.at(kTravelPerCount * counts, state).force, -7.5, 7.5);
    ASSERT_NEAR(board_->force(), expected, 0.0015 * kNewtonsPerVolt) << i;
    most = std::max(most, board_->force());
  }
  EXPECT_NEAR(most, 7.0, 0.001);
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Running);
}

TEST_F(PunchDeviceTest, LetsTheBoardRenderNoMoreThanTheEngineLetsThrough) {
  connect({});
  device_->open();
  device_->renderOnDevice({.model = engine::FiniteElementsSpec{}}, 7.5);
  device_->arm();
  board_->hold();
  double most = 0.0;
  for (int i = 0; i < 1200; ++i) {
    turn(0.0);
    most = std::max(most, std::abs(board_->force()));
  }
  EXPECT_EQ(most, 0.0) << "stopped, and felt all the same";
  for (int i = 0; i < 1200; ++i) {
    turn(2.0);
    timing::sleepUntil(soon(kMillisecond / 4));  // the voltage takes its time
    most = std::max(most, std::abs(board_->force()));
  }
  EXPECT_GT(most, 2.0);
  EXPECT_LE(most, 1.25 * 2.0 + 0.3 + 0.001);
}

TEST_F(PunchDeviceTest, SendsEverySceneThatFits) {
  connect(atRest());
  device_->open();
  engine::KalmanSpec both;
  both.interpolation = recordedCut();
  EXPECT_EQ(whyNot([&] { device_->renderOnDevice({.model = recordedCut()}, 8.0); }), "");
  EXPECT_EQ(whyNot([&] { device_->renderOnDevice({.model = both}, 8.0); }), "");
  device_->renderOnHost();
  device_->arm();
  EXPECT_TRUE(exchangeUntil(
      2.0, [&](const DeviceSample&) { return std::abs(board_->force() - 2.0) < 0.001; }));
}

TEST_F(PunchDeviceTest, SaysWhichScenesStayWithTheHost) {
  connect(atRest());
  device_->open();
  const auto refused = [&](const auto& model) {
    return whyNot([&] { device_->renderOnDevice({.model = model}, 8.0); });
  };
  auto hysteresis = recordedCut();
  hysteresis.branches = engine::Branches::Hysteresis;
  EXPECT_TRUE(says(refused(hysteresis), "an opening branch"));
  engine::InterpolationSpec longer;
  for (int i = 0; i < 129; ++i) longer.curve.push_back({0.1 * i, 1.0});
  EXPECT_TRUE(says(refused(longer), "more than 128 points"));
  engine::FiniteElementsSpec uneven;
  uneven.elementStiffnesses = {1.0, 2.0, 3.0, 2.0, 1.0};
  EXPECT_TRUE(says(refused(uneven), "different stiffness"));
  engine::KalmanSpec smooth;
  smooth.interpolation = recordedCut();
  smooth.smoothing = models::Smoothing::TwoPoint;
  EXPECT_TRUE(says(refused(smooth), "smoothing"));
  EXPECT_TRUE(says(refused(engine::MaterialSpec{}), "bone"));
  engine::FiniteElementsSpec unsound;
  unsound.parameters.toolPosition = unsound.parameters.end;
  EXPECT_TRUE(says(refused(unsound), "unsound"));
}

TEST_F(PunchDeviceTest, WatchesABoardThatDoesNotAnswerToAScene) {
  connect(atRest());
  device_->open();
  board_->order("mute 1000");
  EXPECT_TRUE(says(
      whyNot([&] { device_->renderOnDevice({.model = recordedCut()}, 8.0); }), "does not answer"));
  EXPECT_TRUE(waitUntil([&] { return isFaulted(); }));
  EXPECT_TRUE(says(
      whyNot([&] { device_->renderOnDevice({.model = recordedCut()}, 8.0); }), "is not ready"));
}

// Whether it is fit for use.

const CheckResult* lineOf(const std::vector<CheckResult>& found, const std::string& what) {
  const auto line = std::find_if(
      found.begin(), found.end(), [&](const CheckResult& result) { return result.what == what; });
  return line == found.end() ? nullptr : &*line;
}

bool isFit(const std::vector<CheckResult>& found) {
  return std::none_of(found.begin(), found.end(), [](const CheckResult& result) {
    return result.finding == Finding::Fail;
  });
}

TEST_F(PunchDeviceTest, IsFoundFit) {
  connect({});
  std::vector<CheckResult> found;
  const std::int64_t until = soon(kPatience);
  do {
    found = device_->check(0.4);
  } while (!isFit(found) && timing::now() < until);
  for (const auto& line : found) {
    EXPECT_NE(line.finding, Finding::Fail) << line.what << ": " << line.measured;
    EXPECT_EQ(line.finding == Finding::Pass, line.mend.empty()) << line.what;
  }
  for (const char* what : {"firmware", "telemetry", "round trip", "travel", "force at most"}) {
    EXPECT_NE(lineOf(found, what), nullptr) << what;
  }
  const auto* lost = lineOf(found, "frames lost, doubled, late, damaged");
  ASSERT_NE(lost, nullptr);
  EXPECT_EQ(lost->measured, "0, 0, 0, 0");
  EXPECT_EQ(lineOf(found, "faults that the board reports")->finding, Finding::Pass);
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Checked);
}

TEST_F(PunchDeviceTest, IsFoundUnfitWhereNobodyIsThere) {
  PunchDevice device(settings(folder_ / "nobody"));
  const auto found = device.check(0.1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].finding, Finding::Fail);
  EXPECT_TRUE(says(found[0].mend, "no serial port"));
}

TEST_F(PunchDeviceTest, IsFoundUnfitWhereItsDriverIsBroken) {
  connect(atRest());
  board_->order("driver-fault");
  const auto found = device_->check(0.5);
  const auto* faults = lineOf(found, "faults");
  ASSERT_NE(faults, nullptr);
  EXPECT_EQ(faults->finding, Finding::Fail);
  EXPECT_NE(device_->lifecycle(), Lifecycle::Checked);
}

TEST_F(PunchDeviceTest, IsFoundUnfitWhereItsLineLosesFrames) {
  connect(atRest());
  const CheckResult* lost = nullptr;
  std::vector<CheckResult> found;
  const std::int64_t until = soon(kPatience);
  while (lost == nullptr && timing::now() < until) {
    const std::jthread spoil([&] {
      timing::sleepUntil(soon(150 * kMillisecond));
      board_->order("drop 20");
    });
    found = device_->check(0.4);
    lost = lineOf(found, "frames lost, doubled, late, damaged");
  }
  ASSERT_NE(lost, nullptr);
  EXPECT_EQ(lost->finding, Finding::Fail);
  EXPECT_EQ(lost->measured, "20, 0, 0, 0");
  EXPECT_TRUE(says(lost->mend, "cable"));
}

}  // namespace punch_device_test
}  // namespace haptics::devices
