#include "haptics/emulators/fri_controller.h"

#include <sys/prctl.h>

#include <algorithm>
#include <stdexcept>

#include "haptics/emulators/fri_monitoring.h"
#include "haptics/wire/fri_codec.h"

namespace haptics::emulators {
namespace {

using State = FriSession::State;
using wire::fri::Version;

constexpr int kLongestPeriod = 100;  // [ms]
constexpr int kBacklog = 64;         // most datagrams that are read without a step in between

bool isTorqueMode(const FriController::Options& options) noexcept {
  return options.arm.command == wire::fri::ClientCommandMode::Torque;
}

const FriController::Options& validated(const FriController::Options& options) {
  const bool hasPeriod = options.sendPeriod >= 1 && options.sendPeriod <= kLongestPeriod &&
                         options.receiveMultiplier >= 1 &&
                         options.receiveMultiplier <= kLongestPeriod / options.sendPeriod;
  if (!hasPeriod) {
    throw std::invalid_argument("send and receive periods lie between 1 and 100 ms");
  }
  if (isTorqueMode(options) &&
      options.sendPeriod * options.receiveMultiplier > FriSession::kCommandTimeout) {
    throw std::invalid_argument("commanding torque needs a receive period of 5 ms at most");
  }
  const bool staysHere = options.client.isLoopback() && options.local.isLoopback();
  if (!staysHere && !options.allowsOtherHosts) {
    throw std::invalid_argument(
        "the emulator talks to this machine only (127.0.0.0/8) unless other hosts are allowed");
  }
  if (options.client.port == 0) throw std::invalid_argument("a client has a port");
  const FriSession::DwellTimes& dwellTimes = options.dwellTimes;
  if (std::min(
          {dwellTimes.idle,
           dwellTimes.monitoringWait,
           dwellTimes.monitoringReady,
           dwellTimes.commandingWait,
           dwellTimes.commandingActive}) < 0) {
    throw std::invalid_argument("the time to stay in a state is not negative");
  }
  return options;
}

FriSession::Options sessionOptionsOf(const FriController::Options& options) noexcept {
  return {
      .dwellTimes = options.dwellTimes,
      .period = options.sendPeriod,
      .isTorqueMode = isTorqueMode(options),
      .restartsMotion = options.restartsMotion};
}

/// A version with the other framing: a version without a frame if @p version has one, and vice
/// versa.
Version otherFramingThan(Version version) noexcept {
  return version == Version::V2_7 ? Version::V1_15 : Version::V2_7;
}

}  // namespace

FriController::FriController(const Options& options)
    : options_(validated(options)),
      socket_(options.local),
      impostor_({.address = options.local.address}),
      impairment_(options.impairment),
      faultQueue_(impairment_, options.sendPeriod),
      arm_(options.arm),
      commandCheck_(options.arm.model, options.limits, options.arm.command),
      session_(sessionOptionsOf(options)),
      answers_(options.receiveMultiplier) {
  publish();
}

void FriController::step() noexcept {
  ++report_.periods;
  closePeriod();
  executeEvents();
  advanceState();
  if (faultQueue_.take(FriFaultQueue::OneTimeFault::Stall)) {
    ++report_.stalled;
  } else {
    sendMessage();
  }
  readImpostor();
  arm_.step(options_.sendPeriod / 1000.0);
  publish();
}

void FriController::closePeriod() noexcept {
  ++periodsSinceAnswered_;
  ++periodsSinceCommand_;
  if (session_.state() == State::Idle) {  // no answer was due
    periodsInReceivePeriod_ = 0;
    missingAnswers_ = 0;
    periodsSinceAnswered_ = 1;
    return;
  }
  if (++periodsInReceivePeriod_ < options_.receiveMultiplier) return;
  if (isReceivePeriodAnswered_) {
    missingAnswers_ = 0;
  } else {
    ++missingAnswers_;
    answers_.countMissing();
    connection_.noteMissed();
  }
  periodsInReceivePeriod_ = 0;
  isReceivePeriodAnswered_ = false;
}

void FriController::executeEvents() noexcept {
  using Event = FriFaultQueue::Event;
  if (faultQueue_.take(Event::WrongVersion)) isWrongVersion_ = !isWrongVersion_;
  if (faultQueue_.take(Event::SafetyStop)) session_.setSafetyStop(true);
  if (faultQueue_.take(Event::SafetyReset)) session_.setSafetyStop(false);
  if (faultQueue_.take(Event::Idle)) {
    stopMotion(FriEndReason::Idle);
    session_.endSession();
    arm_.detachHand();
  }
  if (faultQueue_.take(Event::Motion)) session_.queueMotion();
  if (faultQueue_.take(Event::Restart)) restart();
}

void FriController::restart() noexcept {
  stopMotion(FriEndReason::Restart);
  session_.restart();
  answers_.restart();
  connection_.reset();
  arm_.detachHand();
  isReceivePeriodAnswered_ = false;
  isWrongVersion_ = false;
}

void FriController::advanceState() noexcept {
  const State before = session_.state();
  const FriSession::Input input{
      .quality = quality(),
      .missed = missingAnswers_,
      .periodsSinceAnswered = periodsSinceAnswered_};
  if (session_.advance(input)) {
    report_.endJoint = 0;
    brake();
  }
  if (session_.state() == before || !session_.isCommanding()) return;
  lastPosition_ = arm_.heldPosition();
  periodsSinceCommand_ = 1;
  if (session_.isActive()) {
    arm_.attachHand();
  } else {
    arm_.beginMotion();
  }
}

void FriController::stopMotion(FriEndReason end, int joint) noexcept {
  if (!session_.end(end)) return;
  report_.endJoint = joint;
  brake();
}

void FriController::brake() noexcept {
  arm_.hold();
  noteOverlay();
  report_.endAt = options_.clock();
  connection_.reset();
  missingAnswers_ = 0;
  periodsInReceivePeriod_ = 0;
  isReceivePeriodAnswered_ = false;
}

void FriController::noteOverlay() noexcept {
  const bool hasOverlay = arm_.hasOverlay();
  if (hadOverlay_ && !hasOverlay) report_.overlayZeroAt = options_.clock();
  hadOverlay_ = hasOverlay;
}

wire::fri::ConnectionQuality FriController::quality() const noexcept {
  return faultQueue_.isQualityPoor() ? ConnectionQuality::Level::Poor : connection_.level();
}

void FriController::sendMessage() noexcept {
  const FriLinkFields standing{
      .sequence = answers_.nextSequence(),
      .reflected = answers_.reflected(),
      .quality = quality(),
      .sendPeriod = static_cast<std::uint32_t>(options_.sendPeriod),
      .receiveMultiplier = static_cast<std::uint32_t>(options_.receiveMultiplier)};
  const auto message = monitoringMessage(standing, session_, arm_);
  const Version sentVersion =
      isWrongVersion_ ? otherFramingThan(options_.version) : options_.version;
  const std::size_t size = wire::fri::encode(message, sentVersion, sendBuffer_);
  answers_.noteSent(options_.clock(), session_.state() != State::Idle);
  ++report_.messages;
  passToClient(std::span(sendBuffer_).first(size), sentVersion);
  if (faultQueue_.take(FriFaultQueue::OneTimeFault::Impostor)) sendImpostor(message);
}

void FriController::passToClient(std::span<std::uint8_t> datagram, Version sentVersion) noexcept {
  const auto send = [this](std::span<const std::uint8_t> bytes) {
    ++(socket_.send(bytes, options_.client) ? report_.datagrams : report_.unsent);
  };
  if (corrupt(datagram, sentVersion)) {
    impairment_.passWithoutFault(datagram, send);
  } else {
    impairment_.pass(datagram, send);
  }
}

/// Applies at most one of the faults that change the content of a message.
bool FriController::corrupt(std::span<std::uint8_t> datagram, Version sentVersion) noexcept {
  if (isWrongVersion_) {
    ++report_.wrongVersion;
    return true;
  }
  if (faultQueue_.take(FriFaultQueue::OneTimeFault::SixJoints)) {
    report_.sixJoints += leaveOutJoint(datagram, sentVersion) ? 1 : 0;
    return true;
  }
  if (faultQueue_.take(FriFaultQueue::OneTimeFault::NotANumber)) {
    report_.notANumber += setFirstJointToNaN(datagram, sentVersion) ? 1 : 0;
    return true;
  }
  return false;
}

/// Sends a forged copy of the next message from another port, as an attacker could.
void FriController::sendImpostor(const wire::fri::MonitoringMessage& message) noexcept {
  wire::fri::MonitoringMessage forged = message;
  ++forged.header.sequence;
  const std::size_t size = wire::fri::encode(forged, options_.version, impostorBuffer_);
  const auto datagram = std::span(impostorBuffer_).first(size);
  if (impostor_.send(datagram, options_.client)) ++report_.impostors;
}

void FriController::readImpostor() noexcept {
  for (int i = 0; i < kBacklog && impostor_.receive(receiveBuffer_); ++i) ++report_.impostorAnswers;
}

bool FriController::receive(std::int64_t deadline) noexcept {
  const std::int64_t wait = std::max<std::int64_t>(deadline - options_.clock(), 0);
  const auto received = socket_.receive(receiveBuffer_, wait);
  if (!received) return false;
  if (received->from == options_.client) {
    processDatagram(std::span(receiveBuffer_).first(received->size));
  } else {
    answers_.countUnexpectedSender();
  }
  publish();
  return true;
}

void FriController::processDatagram(std::span<const std::uint8_t> datagram) noexcept {
  const std::int64_t now = options_.clock();
  const auto refusal = wire::fri::decode(datagram, options_.version, answer_);
  if (refusal != wire::fri::Refusal::None) {
    answers_.refuse(refusal);
    return;
  }
  if (!answers_.take(answer_.header, now)) return;
  const double period =
      static_cast<double>(timing::kMillisecond * options_.sendPeriod * options_.receiveMultiplier);
  if (!isReceivePeriodAnswered_) {
    connection_.noteAnswered(static_cast<double>(answers_.latency()) / period);
  }
  isReceivePeriodAnswered_ = true;
  periodsSinceAnswered_ = static_cast<int>(answers_.nextSequence() - 1U - answer_.header.reflected);
  execute(answer_);
}

void FriController::execute(const wire::fri::CommandMessage& answer) noexcept {
  if (!session_.isCommanding()) return;
  const auto command = answer.data.value_or(wire::fri::CommandData{});
  if (!session_.isActive()) {
    session_.noteAnswer(commandCheck_.isMirror(command, arm_.heldPosition()));
    return;
  }
  const double seconds = std::max(periodsSinceCommand_, 1) * options_.sendPeriod / 1000.0;
  const FriVerdict verdict = commandCheck_.judge(command, lastPosition_, seconds);
  if (verdict.end != FriEndReason::None) {
    stopMotion(verdict.end, verdict.joint);
    return;
  }
  lastPosition_ = *command.jointPosition;
  periodsSinceCommand_ = 0;
  arm_.apply(command);
  noteOverlay();
}

void FriController::publish() noexcept {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock.owns_lock()) return;  // publish in the next period
  report_.state = session_.state();
  report_.quality = quality();
  report_.connection = connection_.measures();
  report_.lastEnd = session_.lastEnd();
  report_.hasOverlay = arm_.hasOverlay();
  report_.force = arm_.overlayForce();
  report_.torque = arm_.overlayTorque();
  report_.travel = arm_.travel();
  report_.turn = arm_.turn();
  report_.answers = answers_.counts();
  report_.injected = impairment_.counts();
  published_ = report_;
}

FriReport FriController::report() const {
  const std::scoped_lock lock(mutex_);
  return published_;
}

std::string FriController::status() const {
  return statusOf(report());
}

FriController::Reply FriController::command(std::string_view line) {
  if (line == "status") return {.isAccepted = true, .text = status()};
  auto problem = faultQueue_.executeLine(line);
  if (problem) return {.isAccepted = false, .text = *std::move(problem)};
  return {.isAccepted = true};
}

void FriController::run(const std::stop_token& stop) noexcept {
  prctl(PR_SET_TIMERSLACK, 1UL);
  const std::int64_t period = options_.sendPeriod * timing::kMillisecond;
  std::int64_t due = options_.clock();
  while (!stop.stop_requested()) {
    step();
    due += period;
    if (options_.clock() > due + period) {  // do not make up for lost time
      ++report_.latePeriods;
      due = options_.clock();
    }
    while (options_.clock() < due) receive(due);
    // Process answers that arrived while this thread was not running, so that they do not count as
    // missing.
    for (int i = 0; i < kBacklog && receive(0); ++i) {
    }
  }
}

}  // namespace haptics::emulators
