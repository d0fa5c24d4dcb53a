#include "haptics/emulators/fri_answers.h"

#include <cmath>
#include <cstddef>

namespace haptics::emulators {
namespace {

constexpr double kTolerance = 1e-9;  // tolerance of rounding errors at a limit

int numberOf(std::size_t joint) noexcept {
  return static_cast<int>(joint) + 1;
}

}  // namespace

FriEndReason FriCommandCheck::missing(const wire::fri::CommandData& command) const noexcept {
  if (!command.jointPosition) return FriEndReason::PositionMissing;
  if (mode_ == Mode::Wrench && !command.wrench) return FriEndReason::WrenchMissing;
  if (mode_ == Mode::Torque && !command.jointTorque) return FriEndReason::TorqueMissing;
  return FriEndReason::None;
}

FriVerdict FriCommandCheck::judge(
    const wire::fri::CommandData& command,
    const wire::fri::Joints& before,
    double seconds) const noexcept {
  const FriEndReason lack = missing(command);
  if (lack != FriEndReason::None) return {.end = lack};
  const FriVerdict verdict = judgePosition(*command.jointPosition, before, seconds);
  if (verdict.end != FriEndReason::None) return verdict;
  if (mode_ == Mode::Wrench) return judgeWrench(*command.wrench);
  if (mode_ == Mode::Torque) return judgeTorque(*command.jointTorque);
  return {};
}

bool FriCommandCheck::isMirror(
    const wire::fri::CommandData& command, const wire::fri::Joints& joints) const noexcept {
  if (missing(command) != FriEndReason::None) return false;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (!(std::abs((*command.jointPosition)[i] - joints[i]) <= limits_.mirrorTolerance))
      return false;
  }
  return true;
}

FriVerdict FriCommandCheck::judgePosition(
    const wire::fri::Joints& position,
    const wire::fri::Joints& before,
    double seconds) const noexcept {
  for (std::size_t i = 0; i < position.size(); ++i) {
    if (!(std::abs(position[i]) <= arm_.maxPosition[i] + kTolerance)) {
      return {.end = FriEndReason::PositionLimit, .joint = numberOf(i)};
    }
    if (!(std::abs(position[i] - before[i]) <= arm_.maxVelocity[i] * seconds + kTolerance)) {
      return {.end = FriEndReason::PositionJump, .joint = numberOf(i)};
    }
  }
  return {};
}

FriVerdict FriCommandCheck::judgeTorque(const wire::fri::Joints& torque) const noexcept {
  for (std::size_t i = 0; i < torque.size(); ++i) {
    if (!(std::abs(torque[i]) <= arm_.maxTorque[i] + kTolerance)) {
      return {.end = FriEndReason::TorqueLimit, .joint = numberOf(i)};
    }
  }
  return {};
}

FriVerdict FriCommandCheck::judgeWrench(const wire::fri::Vector6& wrench) const noexcept {
  const double force = std::hypot(wrench[0], wrench[1], wrench[2]);
  const double moment = std::hypot(wrench[3], wrench[4], wrench[5]);
  const bool isWithin =
      force <= limits_.maxForce + kTolerance && moment <= limits_.maxMoment + kTolerance;
  return {.end = isWithin ? FriEndReason::None : FriEndReason::WrenchLimit};
}

void FriAnswerMatcher::noteSent(std::int64_t now, bool isAnswerable) noexcept {
  sent_[next_ % kSentHistory] = {.at = now, .isAnswerable = isAnswerable};
  ++next_;
}

bool FriAnswerMatcher::take(const wire::fri::Header& header, std::int64_t now) noexcept {
  // Age of the answered message [messages]; huge if it was never sent.
  const std::uint32_t age = next_ - 1U - header.reflected;
  if (header.reflected >= next_) {
    ++counts_.toUnknownMessage;
    return false;
  }
  SentMessage* message = age < kSentHistory ? &sent_[header.reflected % kSentHistory] : nullptr;
  if (message != nullptr && message->isAnswered) {
    ++counts_.doubled;
    return false;
  }
  if (message != nullptr) message->isAnswered = true;
  const bool isInTime = message != nullptr && age < multiplier_;
  if (isInTime && hasHeard_ && header.sequence < lastClientSequence_) {
    ++counts_.restarts;
    hasHeard_ = false;
  }
  noteReceived(header.sequence);
  if (message != nullptr && !message->isAnswerable) {
    ++counts_.whileIdle;
  } else if (!isInTime) {
    ++counts_.late;
  } else {
    ++counts_.taken;
    latency_ = now - message->at;
    return true;
  }
  return false;
}

void FriAnswerMatcher::noteReceived(std::uint32_t sequence) noexcept {
  if (hasHeard_ && sequence <= lastClientSequence_) {
    if (counts_.lost > 0) --counts_.lost;  // it was overtaken, not lost
    return;
  }
  if (hasHeard_) counts_.lost += sequence - lastClientSequence_ - 1U;
  lastClientSequence_ = sequence;
  hasHeard_ = true;
}

void FriAnswerMatcher::refuse(wire::fri::Refusal refusal) noexcept {
  switch (refusal) {
    case wire::fri::Refusal::WrongIdentifier:
      ++counts_.wrongIdentifier;
      break;
    case wire::fri::Refusal::JointCount:
      ++counts_.wrongJointCount;
      break;
    default:
      ++counts_.undecodable;
  }
}

void FriAnswerMatcher::restart() noexcept {
  next_ = 0;
  sent_ = {};
  lastClientSequence_ = 0;
  hasHeard_ = false;
  latency_ = 0;
}

}  // namespace haptics::emulators
