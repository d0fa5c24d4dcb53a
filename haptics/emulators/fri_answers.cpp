#include "haptics/emulators/fri_answers.h"

namespace haptics::emulators {

void FriAnswers::sent(std::int64_t now, bool isAnswerable) noexcept {
  sent_[next_ % kRemembered] = {.at = now, .isAnswerable = isAnswerable};
  ++next_;
}

bool FriAnswers::take(const wire::fri::Header& header, std::int64_t now) noexcept {
  const std::uint32_t age = next_ - 1U - header.reflected;  // messages; huge if never sent
  if (header.reflected >= next_) {
    ++counts_.neverSent;
    return false;
  }
  Sent* message = age < kRemembered ? &sent_[header.reflected % kRemembered] : nullptr;
  if (message != nullptr && message->isAnswered) {
    ++counts_.doubled;
    return false;
  }
  if (message != nullptr) message->isAnswered = true;
  const bool isInTime = message != nullptr && age < multiplier_;
  if (isInTime && hasHeard_ && header.sequence < heard_) {
    ++counts_.restarts;
    hasHeard_ = false;
  }
  follow(header.sequence);
  if (message != nullptr && !message->isAnswerable) {
    ++counts_.unasked;
  } else if (!isInTime) {
    ++counts_.late;
  } else {
    ++counts_.taken;
    latency_ = now - message->at;
    return true;
  }
  return false;
}

void FriAnswers::follow(std::uint32_t sequence) noexcept {
  if (hasHeard_ && sequence <= heard_) {
    if (counts_.lost > 0) --counts_.lost;  // it comes after others, and was not lost
    return;
  }
  if (hasHeard_) counts_.lost += sequence - heard_ - 1U;
  heard_ = sequence;
  hasHeard_ = true;
}

void FriAnswers::refuse(wire::fri::Refusal refusal) noexcept {
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

void FriAnswers::restart() noexcept {
  next_ = 0;
  sent_ = {};
  heard_ = 0;
  hasHeard_ = false;
  latency_ = 0;
}

}  // namespace haptics::emulators
