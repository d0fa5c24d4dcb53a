// A punch that lies on its wire: whatever it sends, the hand is told forces within the limits of
// the engine, the wire never more than the motor's voltage, nothing once the device is given up,
// and the loop goes on.
//
// The control is the same punch and the same scene without an engine between them.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "base/random.h"
#include "haptics/devices/punch/punch_device.h"
#include "haptics/devices/punch/punch_kind.h"
#include "haptics/emulators/pseudo_terminal.h"
#include "haptics/engine/built_in_models.h"
#include "haptics/engine/force_engine.h"
#include "haptics/timing/monotonic_clock.h"
#include "tests/haptics/devices/device_expectations.h"

namespace haptics::devices {
namespace hostile_punch_test {

using namespace wire::punch;
using timing::kMillisecond;

constexpr double kDt = 0.001;
constexpr double kTravelPerCount = 0.00439;
constexpr double kMostTravel = 11.0;
constexpr double kMostVolts = 12.0;
constexpr engine::SafetyLimits kLimits{.maxForce = 3.0, .maxRate = 300.0};
constexpr int kHonestTicks = 300;  // a hand closes it, and a force comes on
constexpr int kTicks = 300;        // of lies
constexpr int kTries = 5;  // a computer may be too busy for a device, which is given up then
constexpr double kRounding = 1e-9;
constexpr const char* kLeaps = "its position leaps";
constexpr const char* kSilent = "has sent nothing for 50 ms";
constexpr const char* kDamaged = "for 50 ms it has sent damaged frames only";

/// A board of which each turn of a millisecond can be a lie.
class LyingBoard {
 public:
  using Lie = std::function<void(LyingBoard& board, int turn)>;

  explicit LyingBoard(Hello hello) : hello_(hello) {
    hello_.build = kFirmwareBuild;
    thread_ = std::jthread([this](const std::stop_token& stop) {
      timing::raisePriority(timing::kEmulatorPriority);
      for (std::int64_t due = timing::now(); !stop.stop_requested(); due += kMillisecond) {
        turn();
        due = std::max(due, timing::now() - 5 * kMillisecond);
        timing::sleepUntil(due + kMillisecond);
      }
    });
  }

  const std::string& port() const { return line_.port(); }

  void lie(const Lie& lie) {
    const std::scoped_lock lock(gate_);
    lie_ = lie;
    turns_ = 0;
  }
  /// The largest voltage that it was told so far [mV].
  int mostTold() const { return mostTold_.load(); }

  // What lies are made of.
  void say(const Hello& hello) { sayMessage(hello); }
  void sayHello() { sayMessage(hello_); }
  void sayState(double travel) {
    state_.counts = static_cast<std::int32_t>(std::lround(travel / kTravelPerCount));
    sayMessage(state_);
  }
  void sayCounts(std::int32_t counts) {
    state_.counts = counts;
    sayMessage(state_);
  }
  void sayVelocity(std::int32_t velocity) {
    state_.velocity = velocity;
    sayState(travel());
    state_.velocity = 0;
  }
  /// The same number again and again.
  void repeatState() {
    --sequence_;
    sayState(travel());
  }
  void sayBytes(const std::vector<std::uint8_t>& bytes) { line_.write(bytes); }
  std::vector<std::uint8_t> stateInBytes() {
    std::vector<std::uint8_t> bytes(kLargestOnWire);
    bytes.resize(encode(state_, sequence_++, micros(), bytes.data()));
    return bytes;
  }
  /// In and out, two times a second.
  double travel() const {
    const double phase = std::fmod(4.0 * kDt * clock_, 2.0);
    return kMostTravel * (phase < 1.0 ? phase : 2.0 - phase);
  }
  base::SplitMix64 random{20260101};
  std::vector<std::uint8_t> slow;  ///< bytes that it has begun to send

 private:
  static std::uint32_t micros() {
    return static_cast<std::uint32_t>(timing::now() / timing::kMicrosecond);
  }
  template <typename Message>
  void sayMessage(const Message& message) {
    std::array<std::uint8_t, kLargestOnWire> bytes{};
    const auto count = encode(message, sequence_++, micros(), bytes.data());
    line_.write({bytes.data(), count});
  }
  void turn() {
    const std::scoped_lock lock(gate_);
    hear();
    if (!hasHello_) return;
    ++clock_;
    lie_ ? lie_(*this, turns_++) : sayState(travel());
  }
  void hear() {
    std::array<std::uint8_t, 4096> bytes{};
    const auto count = line_.read(bytes);
    Frame frame;
    for (std::size_t i = 0; i < count; ++i) {
      if (!decoder_.take(bytes[i], frame)) continue;
      state_.echo = frame.sequence;
      SetForce told;
      if (frame.type == Type::Hello) {
        sayHello();
        hasHello_ = true;
      } else if (frame.type == Type::SetForce && read(frame, told)) {
        mostTold_ = std::max(mostTold_.load(), std::abs(int{told.voltage}));
      }
    }
  }

  emulators::PseudoTerminal line_;
  std::mutex gate_;
  Hello hello_;
  State state_;
  FrameDecoder decoder_;
  Lie lie_;
  bool hasHello_ = false;
  int turns_ = 0;
  int clock_ = 0;
  std::uint16_t sequence_ = 0;
  std::atomic<int> mostTold_{0};
  std::jthread thread_;
};

constexpr Hello kHello{.counts = 8200, .rate = 1000, .largestVoltage = 12'000, .largestSlew = 600};
constexpr Hello kBoast{
    .counts = 8200, .rate = 10'000, .largestVoltage = 32'000, .largestSlew = 65'535};

struct Attack {
  const char* name;
  LyingBoard::Lie lie;
  const char* fault = "";    ///< what it ends with; empty: the host goes on
  bool isDangerous = false;  ///< without an engine
  Hello hello = kHello;
};
void times(int count, const std::function<void()>& action) {
  for (int i = 0; i < count; ++i) action();
}

/// A byte of a frame now and then.
void sayOneByte(LyingBoard& board) {
  if (board.slow.empty()) board.slow = board.stateInBytes();
  board.sayBytes({board.slow.front()});
  board.slow.erase(board.slow.begin());
}

const Attack kAttacks[] = {
    {"Flood", [](auto& b, int) { times(20, [&] { b.sayState(b.travel()); }); }},
    {"FrameEvery45Milliseconds",
     [](auto& b, int t) {
       if (t % 45 == 44) b.sayState(b.travel());
     }},
    {"SlowLoris",
     [](auto& b, int t) {
       if (t % 4 == 0) sayOneByte(b);
     },
     kSilent},
    {"HelloStorm", [](auto& b, int) { times(20, [&] { b.sayHello(); }); }, kSilent},
    {"HelloStormBetweenStates",
     [](auto& b, int) {
       times(20, [&] { b.say(kBoast); });
       b.sayState(b.travel());
     }},
    {"MoreVoltsThanItsMotorHas",
     [](auto& b, int t) {
       if (t % 10 == 0) b.say(kBoast);
       b.sayState(b.travel());
     },
     "",
     false,
     kBoast},
    {"SameFrameAgain", [](auto& b, int) { b.repeatState(); }, kSilent},
    {"Garbage",
     [](auto& b, int) {
       std::vector<std::uint8_t> bytes(64);
       for (auto& byte : bytes) byte = static_cast<std::uint8_t>(b.random.bits());
       b.sayBytes(bytes);
     },
     kDamaged},
    {"Leap", [](auto& b, int t) { b.sayState(t % 100 < 50 ? 0.0 : kMostTravel); }, kLeaps, true},
    {"OneLeap",
     [](auto& b, int t) {
       const double elsewhere = std::fmod(b.travel() + 0.5 * kMostTravel, kMostTravel);
       b.sayState(t == 50 ? elsewhere : b.travel());
     }},
    {"Alternating",
     [](auto& b, int t) { b.sayState(t % 2 == 0 ? 0.0 : kMostTravel); },
     kLeaps,
     true},
    {"Noise", [](auto& b, int) { b.sayState(kMostTravel * b.random.uniform()); }, kLeaps, true},
    {"HugeVelocity",
     [](auto& b, int t) { b.sayVelocity(t % 2 == 0 ? 2'147'483'647 : -2'147'483'647); }},
    {"HugePosition", [](auto& b, int) { b.sayCounts(2'147'483'647); }, "where it cannot be"},
    {"HugePositionBehindRest", [](auto& b, int) { b.sayCounts(-2'147'483'647); }, "cannot be"}};

struct Told {
  double most = 0.0;      // [N]
  double mostStep = 0.0;  // [N] in a tick, but to none at all
  bool isFinite = true;
  bool isLetGo = true;  // once it was given up
  int mostOnWire = 0;   // [mV]
  std::uint64_t leaps = 0;
  std::string fault;
};

bool isSafe(const Told& told) {
  return told.isFinite && told.most <= kLimits.maxForce + kRounding &&
         told.mostStep <= kLimits.maxRate * kDt + kRounding;
}

/// What a scene tells a hand, with an engine between them or without.
Told attacked(const Attack& attack, bool hasEngine) {
  LyingBoard board(attack.hello);
  PunchDevice device(
      {.port = board.port(), .travelPerCount = kTravelPerCount, .maxVoltage = kMostVolts});
  device.open();
  device.arm();
  engine::ForceEngine engine(device, kLimits);
  engine::CompiledScene scene({.model = engine::publishedInterpolation()});
  engine.setScene(&scene);
  Told told;
  double before = 0.0;
  for (int i = 0; i < kHonestTicks + kTicks; ++i) {
    if (i == kHonestTicks) board.lie(attack.lie);
    device.pacer()->wait(soon(2 * kMillisecond));
    const bool isGone = device.lifecycle() == Lifecycle::Faulted;
    double force = 0.0;
    if (hasEngine) {
      force = engine.tick(kDt).force;
    } else {
      const auto sample = device.read(kDt);
      force =
          scene.respond({.travel = sample.travel, .velocity = sample.velocity, .dt = kDt}).force;
      device.command(force, 0.0);
    }
    told.isFinite = told.isFinite && std::isfinite(force);
    told.most = std::max(told.most, std::abs(force));
    if (force != 0.0) told.mostStep = std::max(told.mostStep, std::abs(force - before));
    if (isGone && force != 0.0) told.isLetGo = false;
    before = force;
  }
  told.leaps = device.link().leaps;
  told.fault = base::describe(device.fault());
  told.mostOnWire = board.mostTold();
  return told;
}

bool isExpected(const Attack& attack, const Told& told) {
  const std::string fault = attack.fault;
  return fault.empty() ? told.fault.empty() : told.fault.find(fault) != std::string::npos;
}

TEST(HostilePunch, IsNeverToldAnUnsafeForce) {
  for (const auto& attack : kAttacks) {
    SCOPED_TRACE(attack.name);
    Told told;
    for (int i = 0; i < kTries && (i == 0 || !isExpected(attack, told)); ++i) {
      told = attacked(attack, true);
      EXPECT_TRUE(isSafe(told)) << told.most << " N, " << told.mostStep << " N in a tick";
      EXPECT_TRUE(told.isLetGo);
      EXPECT_LE(told.mostOnWire, 1000.0 * kMostVolts);
    }
    EXPECT_TRUE(isExpected(attack, told)) << told.fault;
    EXPECT_GT(told.most, 0.1 * kLimits.maxForce) << "there was nothing to lose";
    EXPECT_GT(told.mostOnWire, 0);
  }
}

TEST(HostilePunch, CountsLeapsThatItTolerates) {
  for (const auto& attack : kAttacks) {
    if (std::string(attack.name) != "OneLeap" && std::string(attack.name) != "Flood") continue;
    Told told;
    for (int i = 0; i < kTries && (i == 0 || !told.fault.empty()); ++i) {
      told = attacked(attack, true);
    }
    EXPECT_EQ(told.fault, "") << attack.name;
    EXPECT_EQ(told.leaps, std::string(attack.name) == "OneLeap" ? 2U : 0U) << attack.name;
  }
}

TEST(HostilePunch, IsDangerousWithoutAnEngine) {
  for (const auto& attack : kAttacks) {
    if (!attack.isDangerous) continue;
    EXPECT_FALSE(isSafe(attacked(attack, false))) << attack.name;
  }
}

}  // namespace hostile_punch_test
}  // namespace haptics::devices
