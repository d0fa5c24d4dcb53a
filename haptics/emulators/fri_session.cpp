#include "haptics/emulators/fri_session.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace haptics::emulators {

ConnectionQuality::Level ConnectionQuality::levelOf(const Measures& measures) noexcept {
  for (const auto& [level, worst] : kThresholds) {
    const bool isEnough = measures.share >= worst.share && measures.latency <= worst.latency &&
                          measures.jitter <= worst.jitter;
    if (isEnough) return level;
  }
  return Level::Poor;
}

void ConnectionQuality::add(double latency) noexcept {
  latencies_[next_] = latency;
  next_ = (next_ + 1) % kWindow;
}

void ConnectionQuality::noteAnswered(double latency) noexcept {
  add(std::max(latency, 0.0));
}

void ConnectionQuality::noteMissed() noexcept {
  add(kUnanswered);
}

ConnectionQuality::Measures ConnectionQuality::measures() const noexcept {
  Measures sums;
  int answers = 0;
  int pairs = 0;
  double before = kUnanswered;
  for (std::size_t i = 0; i < kWindow; ++i) {
    const double latency = latencies_[(next_ + i) % kWindow];
    if (latency == kUnanswered) continue;
    ++answers;
    sums.latency += latency;
    if (before != kUnanswered) {
      ++pairs;
      sums.jitter += std::abs(latency - before);
    }
    before = latency;
  }
  return {
      .share = answers / static_cast<double>(kWindow),
      .latency = sums.latency / std::max(answers, 1),
      .jitter = sums.jitter / std::max(pairs, 1)};
}

namespace {

constexpr std::array<std::string_view, 16> kEndReasonNames{
    "no motion has ended",
    "the motion was completed",
    "more than 8 answers in a row were missing",
    "no command came for 5 ms in torque mode",
    "the quality of the connection fell below good",
    "the client did not mirror the joint position within 10 s",
    "a command had no joint position",
    "a command had no wrench",
    "a command had no torque",
    "a joint was commanded beyond its position limit",
    "a joint was commanded faster than its velocity limit",
    "a wrench beyond the limit was commanded",
    "a torque beyond the limit was commanded",
    "safety stop",
    "the session was ended",
    "the controller was restarted"};

}  // namespace

std::string_view nameOf(FriEndReason end) noexcept {
  return kEndReasonNames[static_cast<std::size_t>(end)];
}

bool FriSession::advance(const Input& input) noexcept {
  periods_ = std::min(periods_ + 1, 1'000'000'000);
  const FriEndReason reason = reasonToEnd(input);
  if (reason != FriEndReason::None) return end(reason);
  advanceState(input);
  return false;
}

FriEndReason FriSession::reasonToEnd(const Input& input) const noexcept {
  if (!isCommanding()) return FriEndReason::None;
  const double period = options_.period;
  if (isStopped_) return FriEndReason::SafetyStop;
  if (options_.isTorqueMode && input.periodsSinceAnswered * period > kCommandTimeout) {
    return FriEndReason::CommandsTooRare;
  }
  if (input.missed > kMostMissed) return FriEndReason::AnswersMissing;
  if (input.quality < ConnectionQuality::Level::Good) return FriEndReason::QualityLost;
  if (!isActive())
    return periods_ * period > kMirrorTime ? FriEndReason::NotMirrored : FriEndReason::None;
  const int time = options_.dwellTimes.commandingActive;
  return time > 0 && periods_ >= time ? FriEndReason::Completed : FriEndReason::None;
}

void FriSession::advanceState(const Input& input) noexcept {
  const bool isGood = input.quality >= ConnectionQuality::Level::Good;
  const DwellTimes& dwellTimes = options_.dwellTimes;
  switch (state_) {
    case State::Idle:
      if (!isClosed_ && periods_ >= dwellTimes.idle) enter(State::MonitoringWait);
      break;
    case State::MonitoringWait:
      if (isGood && periods_ >= dwellTimes.monitoringWait) enter(State::MonitoringReady);
      break;
    case State::MonitoringReady:
      if (!isGood) {
        enter(State::MonitoringWait);
      } else if (isQueued_ && !isStopped_ && periods_ >= dwellTimes.monitoringReady) {
        enter(State::CommandingWait);
      }
      break;
    case State::CommandingWait:
      if (mirroredAnswers_ >= kMirroredAnswers && periods_ >= dwellTimes.commandingWait) {
        enter(State::CommandingActive);
      }
      break;
    case State::CommandingActive:
      break;
  }
}

void FriSession::enter(State state) noexcept {
  state_ = state;
  periods_ = 0;
  mirroredAnswers_ = 0;
}

bool FriSession::end(FriEndReason end) noexcept {
  if (!isCommanding()) return false;
  lastEnd_ = end;
  isQueued_ = options_.restartsMotion;
  const bool isOver = end == FriEndReason::Completed;
  isClosed_ = isOver;
  enter(isOver ? State::Idle : State::MonitoringWait);
  return true;
}

void FriSession::endSession() noexcept {
  end(FriEndReason::Idle);
  enter(State::Idle);
  isClosed_ = true;
}

void FriSession::restart() noexcept {
  end(FriEndReason::Restart);
  enter(State::Idle);
  isClosed_ = false;
  isQueued_ = true;
}

}  // namespace haptics::emulators
