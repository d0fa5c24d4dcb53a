#include "haptics/devices/punch/punch_device.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "haptics/devices/device.h"
#include "haptics/devices/punch/punch_kind.h"
#include "haptics/timing/monotonic_clock.h"

namespace haptics::devices {
namespace {

using namespace haptics::wire::punch;
using timing::kMicrosecond;
using timing::kMillisecond;

constexpr std::int64_t kSilenceTimeout = 50 * kMillisecond;
// Of the frames of a silence; a reset damages one.
constexpr std::uint32_t kLeastDamaged = 5;
constexpr std::int64_t kBoardPatience = 40 * kMillisecond;  // then a board disarms itself
constexpr std::uint64_t kToleratedLeaps = 2;  // one wrong position: a leap there, and one back
constexpr std::int64_t kHelloTimeout =
    3000 * kMillisecond;  // QEMU checks for a client once a second
constexpr std::int64_t kHelloInterval = 200 * kMillisecond;

std::string inHex(std::uint64_t number) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4) text += kDigits[(number >> shift) & 15U];
  return text;
}

Capabilities capabilitiesOf(const PunchSettings& settings) {
  return {
      .kind = settings.kind,
      .name = std::string(settings.kind->name) + " on " + settings.port,
      .leastTravel = settings.kind->travel.least,
      .largestTravel = settings.kind->travel.most,
      .maxForce = settings.newtonsPerVolt * settings.maxVoltage,
      .damping = settings.damping,
      .rate = 1000.0,
      .isSimulated = false};
}

}  // namespace

PunchDevice::PunchDevice(PunchSettings settings)
    : WireDevice(
          capabilitiesOf(settings), {.longestWait = 20 * kMillisecond, .silence = kSilenceTimeout}),
      settings_(std::move(settings)) {}

PunchDevice::~PunchDevice() {
  close();
}

void PunchDevice::open() {
  close();
  port_.open(settings_.port, settings_.baud);
  decoder_ = {};
  hasHello_ = false;
  try {
    exchangeHello();
    requireExpectedBoard();
  } catch (...) {
    port_.close();
    throw;
  }
  capabilities_.rate = hello_.rate;
  const double volts = std::min(settings_.maxVoltage, 1e-3 * hello_.largestVoltage);
  capabilities_.maxForce = settings_.newtonsPerVolt * volts;
  resetCounts();
  sequence_ = {};
  damagedBefore_ = decoder_.damaged();
  finishOpening();
}

void PunchDevice::exchangeHello() {
  const std::int64_t until = timing::now() + kHelloTimeout;
  int asked = 0;
  helloCount_ = 0;
  while (!hasHello_ && port_.isOpen() && timing::now() < until) {
    send(Hello{});
    ++asked;
    const std::int64_t again = std::min(until, timing::now() + kHelloInterval);
    while (!hasHello_ && port_.isOpen() && timing::now() < again) {
      port_.waitReadable(again);
      drain();
    }
  }
  // Every Hello disarms the board, so wait for the replies to those still in transit.
  const std::int64_t replyDeadline = timing::now() + 300 * kMillisecond;
  while (hasHello_ && helloCount_ < asked && port_.isOpen() && timing::now() < replyDeadline) {
    isNew_ = false;
    port_.waitReadable(replyDeadline);
    drain();
  }
  if (hasHello_) return;
  throw DeviceError(deviceMessage("device.no_answer", place()));
}

void PunchDevice::requireExpectedBoard() const {
  if (hello_.protocolVersion != kProtocolVersion) {
    throw DeviceError(
        deviceMessage("device.other_protocol", place(), hello_.protocolVersion, kProtocolVersion));
  }
  const std::uint64_t build = settings_.build.value_or(kFirmwareBuild);
  if (hello_.build != build) {
    const auto theirs = inHex(hello_.build);
    throw DeviceError(
        deviceMessage("device.other_firmware", place(), theirs, inHex(build), theirs));
  }
  if (settings_.serial && hello_.serial != *settings_.serial) {
    throw DeviceError(
        deviceMessage("device.other_board", place(), hello_.serial, *settings_.serial));
  }
  if (hello_.rate < 100 || hello_.rate > 10'000 || hello_.largestVoltage <= 0) {
    throw DeviceError(
        deviceMessage("device.impossible_board", place(), hello_.rate, hello_.largestVoltage));
  }
}

void PunchDevice::disconnect(bool isFault) noexcept {
  if (port_.isOpen()) send(Stop{isFault ? StopReason::HostFault : StopReason::Requested});
  port_.close();
}

/// While armed, but before the engine ticks: without messages the board would disarm itself.
void PunchDevice::keepAlive() noexcept {
  const auto expiry = static_cast<std::uint8_t>(settings_.expiry);
  if (lifecycle() == Lifecycle::Armed) send(SetForce{.voltage = 0, .expiry = expiry});
}

void PunchDevice::beginForces() noexcept {
  drain();
  resetCounts();
  sequence_ = {};
  damagedBefore_ = decoder_.damaged();
  isNew_ = false;
  hasTravel_ = false;
  armedAt_ = hostTime_ = lastSentAt_ = timing::now();
  longestPause_ = 0;
  send(Arm{.isArmed = true, .expiry = static_cast<std::uint8_t>(settings_.expiry)});
}

void PunchDevice::stopForces() noexcept {
  send(SetForce{.voltage = 0, .expiry = 1});
  send(Arm{.isArmed = false, .expiry = 1});
}

/// Waits for a new State message, at most until @p deadline [ns]; returns whether there is one.
bool PunchDevice::waitForMessage(std::int64_t deadline) noexcept {
  while (port_.isOpen()) {
    if (drain()) return true;
    if (timing::now() >= deadline) return false;
    port_.waitReadable(deadline);
  }
  return false;
}

/// Processes all bytes that have arrived. Returns whether there is a State message that read() has
/// not used.
bool PunchDevice::drain() noexcept {
  std::array<std::uint8_t, 512> bytes{};
  for (;;) {
    const std::size_t count = port_.read(bytes);
    if (count == 0) break;
    const std::int64_t at = timing::now();
    Frame frame;
    for (std::size_t i = 0; i < count; ++i) {
      if (decoder_.take(bytes[i], frame)) take(frame, at);
    }
    if (count < bytes.size()) break;
  }
  report_.damaged = decoder_.damaged() - damagedBefore_;
  return isNew_;
}

void PunchDevice::take(const Frame& frame, std::int64_t at) noexcept {
  if (frame.type == Type::Hello) {
    if (wire::punch::read(frame, hello_)) {
      hasHello_ = true;
      ++helloCount_;
    }
    sequence_.take(frame.sequence);
    return;
  }
  const auto verdict = sequence_.take(frame.sequence);
  report_.lost = sequence_.lost();
  report_.doubled = sequence_.duplicates();
  report_.late = sequence_.late();
  report_.restarts = sequence_.restarts();
  using Verdict = wire::SequenceCheck<std::uint16_t>::Verdict;
  if (verdict == Verdict::Doubled || verdict == Verdict::Late) return;
  if (frame.type == Type::State) {
    handleState(frame, at);
  } else if (frame.type == Type::ModelReply) {
    ModelReply answer;
    if (wire::punch::read(frame, answer)) lastModelReply_ = answer;
  }
}

void PunchDevice::handleState(const Frame& frame, std::int64_t at) noexcept {
  State state;
  if (!wire::punch::read(frame, state)) return;
  if (isNew_) ++report_.skipped;
  if (((state.faults & ~state_.faults) & kExpired) != 0) ++report_.expired;
  const auto since = frame.time - static_cast<std::uint32_t>(deviceTime_);
  deviceTime_ += since;  // unwrapped
  drift_.add(1000 * deviceTime_, at);
  if (state.echo != lastEcho_) {
    lastEcho_ = state.echo;
    const std::int64_t sent = sentAt_[state.echo % sentAt_.size()];
    report_.roundTrip.add(1e-3 * static_cast<double>(at - sent));
  }
  const double before = travel();
  state_ = state;
  if (std::exchange(hasTravel_, true)) countLeap(before, 1e-6 * static_cast<double>(since));
  hostTime_ = at;
  damagedAtState_ = decoder_.damaged();
  isNew_ = true;
  ++report_.received;
}

/// Counts a change of travel within @p seconds that is too fast for any hand. Messages are at least
/// a period apart; shorter times are imprecise. A travel may be wrong by half a count, so a slight
/// movement of the hand can change it by a whole count.
void PunchDevice::countLeap(double before, double seconds) noexcept {
  const double apart = std::max(seconds, 1.0 / capabilities_.rate);
  const double count = std::abs(settings_.travelPerCount);
  const double largest = settings_.kind->travel.fastest * apart + 1.5 * count;
  if (std::abs(travel() - before) > largest) ++report_.leaps;
}

/// The fault bits that end a trial. Shortly after arming no bit does, because the device may not
/// have processed the Arm message yet, which clears old bits.
std::uint8_t PunchDevice::relevantFaults() const noexcept {
  const bool isSettled = hostTime_ - armedAt_ > kSilenceTimeout;
  return static_cast<std::uint8_t>(state_.faults & (isSettled ? (kLatchedFaults | kNotArmed) : 0));
}

DeviceSample PunchDevice::read(double) noexcept {
  stopKeepAlive();
  if (lifecycle() == Lifecycle::Faulted) return {.status = DeviceStatus::NotAnswering};
  if (!port_.isOpen()) {
    fail("fault.unplugged");
    return {.status = DeviceStatus::NotAnswering};
  }
  drain();
  const DeviceSample sample{
      .status = isNew_ ? DeviceStatus::Ok : DeviceStatus::Stale,
      .travel = travel(),
      .velocity = settings_.travelPerCount * state_.velocity,
      .leaps = static_cast<std::uint32_t>(report_.leaps),
      .deviceTime = 1000 * deviceTime_};
  if (!isNew_) {
    ++report_.stale;
    if (timing::now() - hostTime_ <= kSilenceTimeout) return sample;
    const bool isNoise = decoder_.damaged() - damagedAtState_ >= kLeastDamaged;
    fail(isNoise ? DeviceFault("fault.only_damaged") : DeviceFault("fault.board_silent"));
    return {.status = DeviceStatus::NotAnswering};
  }
  isNew_ = false;
  isUnanswered_ = true;
  const std::uint8_t faults = relevantFaults();
  const bool isPlausible = settings_.kind->serial.isPlausibleTravel(sample.travel);
  const bool leaps = report_.leaps > kToleratedLeaps;
  if (faults == 0 && isPlausible && !leaps) return sample;
  const auto pause = std::max(longestPause_, timing::now() - lastSentAt_);
  fail(
      faults == 0 && !isPlausible     ? DeviceFault("fault.lost_count")
      : faults == 0                   ? DeviceFault("fault.leaps")
      : (faults & kDriverFault) != 0  ? DeviceFault("fault.driver")
      : (faults & kEncoderFault) != 0 ? DeviceFault("fault.encoder")
      : (faults & kTooFast) != 0      ? DeviceFault("fault.too_fast")
      : pause >= kBoardPatience       ? DeviceFault("fault.host_paused")
                                      : DeviceFault("fault.let_go"));
  return {.status = DeviceStatus::Faulted};
}

void PunchDevice::command(double force, double /*torque*/) noexcept {
  if (!port_.isOpen() || isKeepAliveRunning()) return;
  // One force per sample: a board that sends no samples gets no force, and switches its force off.
  const bool isAnswer = std::exchange(isUnanswered_, false);
  if (!isAnswer && force != 0.0) return;
  const auto expiry = static_cast<std::uint8_t>(settings_.expiry);
  if (lifecycle() == Lifecycle::Armed) setLifecycle(Lifecycle::Running);
  const double most = capabilities_.maxForce;
  if (std::abs(force) > most) ++report_.clipped;
  const double bounded = std::isfinite(force) ? std::clamp(force, -most, most) : 0.0;
  const double millivolts = 1000.0 * bounded / settings_.newtonsPerVolt;
  if (sceneHash_) {
    // The engine's force bounds the force that the board computes, with a tolerance for motion
    // since the sample. If the engine's force is 0, so is the board's.
    constexpr double kForceTolerance = 1.25;
    constexpr double kLeastTolerance = 0.3;  // [N]
    const double ceiling = bounded == 0.0 ? 0.0
                                          : kForceTolerance * std::abs(millivolts) +
                                                1000.0 * kLeastTolerance / settings_.newtonsPerVolt;
    const auto volts = static_cast<std::int16_t>(std::min(ceiling, 32767.0));
    send(Render{.hash = *sceneHash_, .expiry = expiry, .most = volts});
    return;
  }
  send(SetForce{.voltage = static_cast<std::int16_t>(std::lround(millivolts)), .expiry = expiry});
}

}  // namespace haptics::devices
