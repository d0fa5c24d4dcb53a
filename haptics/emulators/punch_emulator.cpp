#include "haptics/emulators/punch_emulator.h"

#include <charconv>
#include <cmath>
#include <cstdio>

#include "base/search.h"
#include "haptics/devices/punch/punch_kind.h"
#include "haptics/timing/monotonic_clock.h"

namespace haptics::emulators {
namespace {

using timing::kMillisecond;

constexpr std::int64_t kWatchdog = 40 * kMillisecond;

devices::Mechanism withoutEncoder(const devices::DeviceKind& kind) {
  auto mechanism = kind.mechanism;
  mechanism.resolution = 0.0;  // counts() simulates the encoder
  return mechanism;
}

Impairment::Options serialFaults(std::uint64_t seed) {
  return {.seed = seed, .delimiter = std::uint8_t{0}};
}

/// A parsed command: "drop 3" as "drop" and 3.
struct Order {
  std::string_view word;
  std::optional<int> number;
};

Order orderIn(std::string_view line) {
  const auto space = line.find(' ');
  Order order{.word = line.substr(0, space)};
  if (space == std::string_view::npos) return order;
  const auto rest = line.substr(space + 1);
  int number = 0;
  const auto result = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (result.ec == std::errc() && result.ptr == rest.data() + rest.size()) order.number = number;
  return order;
}

/// A message about what is wrong with the number of a command; empty if it is valid.
std::string problemIn(const Order& order, std::string_view line) {
  constexpr int kMost = 1'000'000;
  const bool isCount = base::contains(kFaultNames, order.word);
  const bool isTime = order.word == "mute" || order.word == "stall";
  const bool isLeap = order.word == "leap";
  if (!isCount && !isTime && !isLeap) return {};
  const int least = isLeap ? -kMost : 1;
  if (order.number && *order.number >= least && *order.number <= kMost) return {};
  return "'" + std::string(line) + "': " +
         (isCount  ? "N"
          : isTime ? "MS"
                   : "COUNTS") +
         " is a whole number from " + std::to_string(least) + " to " + std::to_string(kMost) +
         ", such as \"" + std::string(order.word) +
         (isCount  ? " 3"
          : isTime ? " 400"
                   : " 5000") +
         "\"";
}

}  // namespace

PunchEmulator::PunchEmulator(const Options& options)
    : options_(options),
      line_(options.link),
      impairment_(serialFaults(options.seed)),
      hand_(options.person),
      handle_(devices::simulated(*options.kind), withoutEncoder(*options.kind), hand_),
      start_(timing::now()) {
  if (options_.limits.build == 0) options_.limits.build = devices::kFirmwareBuild;
  if (options_.limits.serial == 0) options_.limits.serial = 1;
  restart();
}

void PunchEmulator::restart() noexcept {
  program_.emplace(*this, options_.limits);
}

void PunchEmulator::step() noexcept {
  const double dt = 1.0 / options_.limits.rate;
  handle_.command(force(), 0.0);
  const auto sample = handle_.read(dt);
  if (sample.status == devices::DeviceStatus::Ok) travel_ = sample.travel;
  ++steps_;
  const std::int64_t now = timing::now();
  if (now < stalledUntil_) {
    if (now - stalledSince_ > kWatchdog && voltage_ != 0) drive(0);
    return;
  }
  if (stalledUntil_ != 0) {
    if (stalledUntil_ - stalledSince_ > kWatchdog) restart();
    stalledUntil_ = 0;
  }
  program_->step();
}

std::uint32_t PunchEmulator::micros() const noexcept {
  const double passed = static_cast<double>(timing::now() - start_) / 1000.0;
  return static_cast<std::uint32_t>(
      static_cast<std::int64_t>(passed * (1.0 + 1e-6 * options_.clockDrift)));
}

std::int32_t PunchEmulator::counts() const noexcept {
  return static_cast<std::int32_t>(std::lround(travel_ / options_.travelPerCount)) + encoderError_;
}

void PunchEmulator::drive(std::int16_t millivolts) noexcept {
  if (voltage_ != 0 && millivolts == 0) {
    voltageZeroAt_ = timing::now();
    if (forceOffAt_ == 0) forceOffAt_ = voltageZeroAt_;
  }
  voltage_ = millivolts;
}

int PunchEmulator::read() noexcept {
  if (inputPosition_ == inputSize_) {
    inputPosition_ = 0;
    inputSize_ = line_.read(input_);
  }
  return inputPosition_ < inputSize_ ? input_[inputPosition_++] : -1;
}

void PunchEmulator::write(const std::uint8_t* bytes, std::size_t count) noexcept {
  if (timing::now() < mutedUntil_) return;
  impairment_.pass(
      {bytes, count}, [this](std::span<const std::uint8_t> frame) { line_.write(frame); });
}

void PunchEmulator::noteFault() noexcept {
  faultAt_ = timing::now();
  forceOffAt_ = 0;
  hadForce_ = voltage_ != 0;
}

std::optional<double> PunchEmulator::motorOffAfter() const noexcept {
  if (faultAt_ == 0 || !hadForce_ || forceOffAt_ == 0) return std::nullopt;
  return 1e-6 * static_cast<double>(forceOffAt_ - faultAt_);
}

std::string_view PunchEmulator::help() noexcept {
  return "drop N, double N, reorder N, delay N, damage N, garbage N, mute MS, stall MS, leap "
         "COUNTS, "
         "driver-fault, mend, reset, unplug, plug, status, help, quit; N counts frames to the "
         "host; "
         "N and MS are whole numbers from 1 to 1000000, COUNTS from -1000000 to 1000000";
}

std::string PunchEmulator::command(std::string_view line) {
  const Order order = orderIn(line);
  std::string wrong = problemIn(order, line);
  if (!wrong.empty()) return wrong;
  for (std::size_t i = 0; i < kFaultNames.size(); ++i) {
    if (order.word != kFaultNames[i]) continue;
    impairment_.schedule(static_cast<Fault>(i), *order.number);
    return {};
  }
  const std::int64_t time = timing::now() + order.number.value_or(0) * kMillisecond;
  if (order.word != "mend" && order.word != "plug") noteFault();
  if (order.word == "mute") {
    mutedUntil_ = time;
  } else if (order.word == "stall") {
    stalledSince_ = timing::now();
    stalledUntil_ = time;
  } else if (order.word == "leap") {
    encoderError_ += *order.number;
  } else if (order.word == "driver-fault") {
    hasDriverFault_ = true;
  } else if (order.word == "mend") {
    hasDriverFault_ = false;
    encoderError_ = 0;
  } else if (order.word == "reset") {
    drive(0);
    restart();
  } else if (order.word == "unplug") {
    line_.unplug();
  } else if (order.word == "plug") {
    line_.plugIn();
  } else {
    return "'" + std::string(line) + "' is no command. There are: " + std::string(help());
  }
  return {};
}

std::string PunchEmulator::status() const {
  std::array<char, 256> text{};
  const auto after = motorOffAfter();
  std::snprintf(
      text.data(),
      text.size(),
      "device=%s plugged=%d armed=%d travel=%.4f force_n=%.4f voltage_mv=%d steps=%llu "
      "let_go_ms=%.3f zero_at_ns=%lld",
      std::string(options_.kind->name).c_str(),
      line_.isPlugged() ? 1 : 0,
      program_->isArmed() ? 1 : 0,
      travel_,
      force(),
      voltage_,
      static_cast<unsigned long long>(steps_),
      after.value_or(-1.0),
      static_cast<long long>(voltageZeroAt_));
  std::string all = text.data();
  const auto counts = impairment_.counts();
  for (std::size_t i = 0; i < kFaultNames.size(); ++i) {
    all += " " + std::string(kFaultNames[i]) + "=" + std::to_string(counts.of[i]);
  }
  return all;
}

}  // namespace haptics::emulators
