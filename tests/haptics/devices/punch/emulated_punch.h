#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include <gtest/gtest.h>

#include "haptics/devices/punch/punch_device.h"
#include "haptics/emulators/punch_emulator.h"
#include "haptics/timing/monotonic_clock.h"
#include "tests/haptics/devices/device_expectations.h"
#include "tests/support/scratch_folder.h"

/// The punch's host against its emulator: the firmware's own program behind a pseudo-terminal.
///
/// A device is given up after 50 ms of silence, and a computer may be too busy for that: what is
/// disturbed so is tried again.
namespace haptics::devices::emulated_punch {

using emulators::Fault;
using emulators::PunchEmulator;
using timing::kMillisecond;
using timing::kSecond;

inline constexpr double kNewtonsPerVolt = 0.667;
inline constexpr double kTravelPerCount = 0.00439;
inline constexpr std::int64_t kPatience = 8 * kSecond;  // for what has to be tried again

/// An emulated punch that goes on by itself, a thousand times a second, or turn by turn.
class Board {
 public:
  explicit Board(const PunchEmulator::Options& options = {}) : emulator_(options) { goOn(); }

  const std::string& port() const { return emulator_.port(); }

  void goOn() {
    thread_ = std::jthread([this](const std::stop_token& stop) {
      timing::raisePriority(timing::kEmulatorPriority);
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
inline PunchEmulator::Options atRest() {
  return {.person = {.closed = 0.0}};
}

class EmulatedPunch : public testing::Test {
 protected:
  PunchSettings settings(const std::string& port) {
    return {.port = port, .travelPerCount = kTravelPerCount, .newtonsPerVolt = kNewtonsPerVolt};
  }
  /// @param patience  after which the board lets go of a computer that is silent [ms]; at first it
  ///     forgives one that is busy.
  void connect(PunchEmulator::Options options, std::uint16_t patience = 5000) {
    options.newtonsPerVolt = kNewtonsPerVolt;
    options.travelPerCount = kTravelPerCount;
    options.link = folder_ / "punch";
    options.limits.silence = patience;
    board_.emplace(options);
    device_ = std::make_unique<PunchDevice>(settings(board_->port()));
  }

  /// One exchange, while the board goes on by itself.
  DeviceSample exchange(double force) {
    device_->pacer()->wait(soon(2 * kMillisecond));
    const auto sample = device_->read(0.001);
    device_->command(force, 0.0);
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

}  // namespace haptics::devices::emulated_punch
