#pragma once

#include "haptics/firmware/on_device_scene.h"
#include "haptics/wire/punch_codec.h"

namespace haptics::firmware {

/// Properties and limits of a punch; the defaults fit every board.
struct PunchLimits {
  uint64_t build = 0;
  uint32_t serial = 0;
  uint16_t countsPerTurn = 8192;   ///< AMT 102, 2048 pulses, four counts each
  uint16_t rate = 1000;            ///< rate of step() [Hz]
  int16_t largestVoltage = 12000;  ///< [mV]
  uint16_t largestSlew = 1200;     ///< [mV/ms]: the voltage can fall from its maximum to 0 in 10 ms
  int32_t maxCountsPerStep = 400;  ///< larger changes per step mean an encoder fault
  int32_t mostVelocity = 150'000;  ///< [counts/s]
  uint16_t silence = 40;  ///< time without a valid frame after which the device disarms [ms]
};

/// The punch's firmware: reads the encoder, executes the host's commands, and switches the force
/// off when they stop. Call step() once per loop; see docs/punch-protocol.md.
///
/// Hardware provides
///     uint32_t micros();                              a clock [µs], wraps
///     int32_t counts();                               of the encoder; closing counts up
///     void drive(int16_t millivolts);                 positive resists closing
///     bool hasDriverFault();
///     int read();                                     the next byte from the host, or -1
///     void write(const uint8_t* bytes, size_t count); whole frames; drops them where there is no
///     room
template <typename Hardware>
class PunchProgram {
 public:
  PunchProgram(Hardware& hardware, const PunchLimits& limits) noexcept
      : hardware_(hardware), limits_(limits) {
    hardware_.drive(0);
    lastCounts_ = hardware_.counts();
    for (auto& sample : countHistory_) sample = lastCounts_;
    lastTime_ = hardware_.micros();
    report(wire::punch::EventCode::Reset, 0);
  }

  /// Performs one iteration of the loop.
  void step() noexcept {
    now_ = hardware_.micros();
    const uint32_t elapsed = now_ - lastTime_;
    checkTiming(elapsed);
    receive();
    observe();
    drive(elapsed);
    sendState();
    lastTime_ = now_;
  }

  bool isArmed() const noexcept { return isArmed_; }
  int16_t voltage() const noexcept { return static_cast<int16_t>(voltage_); }

 private:
  using Type = wire::punch::Type;
  using EventCode = wire::punch::EventCode;

  static constexpr int kWindow = 8;  // number of steps over which the velocity is measured
  static constexpr int kMaxBytesPerStep = 512;  // limits the time spent on a host that floods

  void checkTiming(uint32_t elapsed) noexcept {
    const uint32_t period = 1'000'000U / limits_.rate;
    if (hasStepped_ && elapsed > period + period / 2 && lateLoops_ < 0xFFFF) ++lateLoops_;
    if (now_ < lastTime_) faults_ |= wire::punch::kClockWrapped;
    hasStepped_ = true;
  }

  void receive() noexcept {
    const uint32_t damagedBefore = decoder_.damaged();
    wire::punch::Frame frame;
    for (int i = 0; i < kMaxBytesPerStep; ++i) {
      const int byte = hardware_.read();
      if (byte < 0) break;
      if (decoder_.take(static_cast<uint8_t>(byte), frame)) handle(frame);
    }
    const uint32_t damaged = decoder_.damaged() - damagedBefore;
    if (damaged > 0) countDamaged(damaged);
  }

  void countDamaged(uint32_t frames) noexcept {
    faults_ |= wire::punch::kBadFrames;
    const uint32_t all = badFrames_ + frames;
    badFrames_ = static_cast<uint16_t>(all > 0xFFFF ? 0xFFFF : all);
  }

  /// Reads a frame. Only a valid frame counts as a sign of life of the host, and only its sequence
  /// number is echoed.
  template <typename Message>
  bool readValid(const wire::punch::Frame& frame, Message& message) noexcept {
    if (!wire::punch::read(frame, message)) {
      countDamaged(1);
      return false;
    }
    echo_ = frame.sequence;
    lastFrameAt_ = now_;
    return true;
  }

  void handle(const wire::punch::Frame& frame) noexcept {
    // Before Hello all other frames are ignored.
    if (frame.type == Type::Hello) {
      answerHello(frame);
    } else if (!hasHello_) {
      return;
    } else if (frame.type == Type::Arm) {
      arm(frame);
    } else if (frame.type == Type::SetForce) {
      setForce(frame);
    } else if (frame.type == Type::Render) {
      render(frame);
    } else if (frame.type == Type::Model || frame.type == Type::ModelTable) {
      takeScene(frame);
    } else if (frame.type == Type::Stop) {
      wire::punch::Stop order;
      readValid(frame, order);
      disarm();  // even if the frame is not valid
    } else {
      countDamaged(1);
    }
  }

  void answerHello(const wire::punch::Frame& frame) noexcept {
    wire::punch::Hello host;
    if (!readValid(frame, host)) return;
    disarm();
    hasHello_ = host.protocolVersion == wire::punch::kProtocolVersion;
    lateLoops_ = 0;
    badFrames_ = 0;
    send(wire::punch::Hello{
        .protocolVersion = wire::punch::kProtocolVersion,
        .build = limits_.build,
        .serial = limits_.serial,
        .counts = limits_.countsPerTurn,
        .rate = limits_.rate,
        .largestVoltage = limits_.largestVoltage,
        .largestSlew = limits_.largestSlew});
    if (!hasHello_) send(wire::punch::Stop{wire::punch::StopReason::VersionMismatch});
  }

  void arm(const wire::punch::Frame& frame) noexcept {
    wire::punch::Arm order;
    if (!readValid(frame, order)) return;
    if (!order.isArmed) return disarm();
    faults_ = wire::punch::kNoFault;
    longestExpiry_ = order.expiry;
    isArmed_ = true;
    setExpiry(order.expiry);  // the first force has the same time limit
    isRendering_ = false;
    commandedVoltage_ = 0;
    report(EventCode::Armed, order.expiry);
  }

  void disarm() noexcept {
    if (isArmed_) report(EventCode::Disarmed, 0);
    isArmed_ = false;
    isRendering_ = false;
    commandedVoltage_ = 0;
  }

  void setForce(const wire::punch::Frame& frame) noexcept {
    wire::punch::SetForce order;
    if (!readValid(frame, order) || !isArmed_) return;
    isRendering_ = false;
    commandedVoltage_ = order.voltage;
    setExpiry(order.expiry);
  }

  void render(const wire::punch::Frame& frame) noexcept {
    wire::punch::Render order;
    if (!readValid(frame, order) || !isArmed_) return;
    const bool isMeant = scene_.isReady() && scene_.hash() == order.hash;
    if (isMeant && !isRendering_) scene_.reset();
    isRendering_ = isMeant;
    commandedVoltage_ = 0;
    renderingLimit_ = order.most;
    if (isMeant) setExpiry(order.expiry);
  }

  void setExpiry(uint8_t expiry) noexcept {
    expiry_ = expiry < longestExpiry_ ? expiry : longestExpiry_;
    lastForceAt_ = now_;
    hasExpired_ = false;
    faults_ &= static_cast<uint8_t>(~wire::punch::kExpired);
  }

  void takeScene(const wire::punch::Frame& frame) noexcept {
    wire::punch::ModelReply answer;
    wire::punch::Model model;
    wire::punch::ModelTable table;
    const bool isModel = frame.type == Type::Model;
    if (!(isModel ? readValid(frame, model) : readValid(frame, table))) return;
    if (isArmed_) {
      answer.verdict = wire::punch::ModelVerdict::Armed;
    } else if (isModel) {
      answer.verdict = scene_.take(model, frame.payload, frame.size);
    } else {
      answer.verdict = scene_.take(table, frame.payload, frame.size);
    }
    answer.hash = scene_.hash();
    send(answer);
  }

  /// Reads the encoder and estimates the velocity. An impossible change of counts or velocity is a
  /// fault, which switches the force off.
  void observe() noexcept {
    const int32_t counts = hardware_.counts();
    const int32_t leap = countDifference(lastCounts_, counts);
    if (leap > limits_.maxCountsPerStep || leap < -limits_.maxCountsPerStep) {
      latchFault(wire::punch::kEncoderFault, EventCode::EncoderFault, static_cast<uint32_t>(leap));
    }
    lastCounts_ = counts;
    velocity_ = velocityOf(countDifference(countHistory_[oldestIndex_], counts));
    countHistory_[oldestIndex_] = counts;
    oldestIndex_ = (oldestIndex_ + 1) % kWindow;
    if (velocity_ > limits_.mostVelocity || velocity_ < -limits_.mostVelocity) {
      latchFault(wire::punch::kTooFast, EventCode::TooFast, static_cast<uint32_t>(velocity_));
    }
    if (hardware_.hasDriverFault()) {
      latchFault(wire::punch::kDriverFault, EventCode::DriverFault, 0);
    }
  }

  /// Difference of two counts of an encoder that wraps around.
  static int32_t countDifference(int32_t from, int32_t to) noexcept {
    return static_cast<int32_t>(static_cast<uint32_t>(to) - static_cast<uint32_t>(from));
  }

  /// Converts a change of counts over the window to a velocity [counts/s], bounded far above
  /// mostVelocity.
  int32_t velocityOf(int32_t counts) const noexcept {
    constexpr int32_t kMost = 200'000;  // times 10 kHz still fits into 32 bits
    const int32_t bounded = counts > kMost ? kMost : counts < -kMost ? -kMost : counts;
    return bounded * limits_.rate / kWindow;
  }

  void latchFault(uint8_t fault, EventCode code, uint32_t value) noexcept {
    if ((faults_ & fault) == 0) report(code, value);
    faults_ |= fault;
  }

  int32_t target() noexcept {
    if (!isArmed_ || (faults_ & wire::punch::kLatchedFaults) != 0) return 0;
    const uint32_t age = now_ - lastForceAt_;
    if (hasExpired_ || age > 1000U * expiry_) {  // latched, because the age wraps around
      if (!hasExpired_ && voltage_ != 0) report(EventCode::WatchdogFired, age);
      hasExpired_ = true;
      faults_ |= wire::punch::kExpired;
      if (now_ - lastFrameAt_ > 1000U * limits_.silence) disarm();
      return 0;
    }
    if (!isRendering_) return commandedVoltage_;
    const int32_t rendered = scene_.millivoltsAt(lastCounts_);
    return rendered > renderingLimit_    ? renderingLimit_
           : rendered < -renderingLimit_ ? -renderingLimit_
                                         : rendered;
  }

  /// Moves the voltage towards the target, with limited slew rate and within the largest voltage.
  void drive(uint32_t elapsed) noexcept {
    int32_t goal = target();
    const int32_t most = limits_.largestVoltage;
    if (goal > most || goal < -most) {
      goal = goal > most ? most : -most;
      faults_ |= wire::punch::kSaturated;
    }
    const uint32_t bounded = elapsed > 5000U ? 5000U : elapsed;
    const auto reach = static_cast<int32_t>(limits_.largestSlew * bounded / 1000U);
    const int32_t way = goal - voltage_;
    voltage_ += way > reach ? reach : way < -reach ? -reach : way;
    hardware_.drive(static_cast<int16_t>(voltage_));
  }

  void sendState() noexcept {
    if (!hasHello_) return;
    const uint8_t armed = isArmed_ ? 0 : wire::punch::kNotArmed;
    send(wire::punch::State{
        .counts = lastCounts_,
        .velocity = velocity_,
        .voltage = static_cast<int16_t>(voltage_),
        .faults = static_cast<uint8_t>(faults_ | armed),
        .echo = echo_,
        .lateLoops = lateLoops_,
        .badFrames = badFrames_,
        .isRendering = isRendering_});
    constexpr uint8_t kReportedOnce =
        wire::punch::kBadFrames | wire::punch::kSaturated | wire::punch::kClockWrapped;
    faults_ &= static_cast<uint8_t>(~kReportedOnce);
  }

  void report(EventCode code, uint32_t value) noexcept {
    if (hasHello_) send(wire::punch::Event{code, value});
  }

  template <typename Message>
  void send(const Message& message) noexcept {
    uint8_t bytes[wire::punch::kLargestOnWire];
    const size_t count = wire::punch::encode(message, sequence_++, now_, bytes);
    hardware_.write(bytes, count);
  }

  Hardware& hardware_;
  PunchLimits limits_;
  wire::punch::FrameDecoder decoder_;
  OnDeviceScene scene_;

  uint32_t now_ = 0;
  uint32_t lastTime_ = 0;
  bool hasStepped_ = false;
  bool hasHello_ = false;
  uint16_t sequence_ = 0;
  uint16_t echo_ = 0;
  uint16_t lateLoops_ = 0;
  uint16_t badFrames_ = 0;
  uint8_t faults_ = wire::punch::kNoFault;

  bool isArmed_ = false;
  bool isRendering_ = false;
  bool hasExpired_ = false;
  uint8_t longestExpiry_ = 20;
  uint8_t expiry_ = 0;
  uint32_t lastForceAt_ = 0;
  uint32_t lastFrameAt_ = 0;
  int32_t commandedVoltage_ = 0;
  int32_t renderingLimit_ = 0;  ///< largest voltage while the device renders its scene itself [mV]
  int32_t voltage_ = 0;

  int32_t lastCounts_ = 0;
  int32_t velocity_ = 0;
  int32_t countHistory_[kWindow] = {};
  int oldestIndex_ = 0;
};

}  // namespace haptics::firmware
