#include "haptics/emulators/impairment.h"

#include <algorithm>
#include <stdexcept>

namespace haptics::emulators {
namespace {

constexpr int kReorderWait = 1;  // a reordered frame waits for one other frame

bool areValid(const Impairment::Options& options) {
  double sum = 0.0;
  for (const double share : options.shares) {
    if (!(share >= 0.0)) return false;
    sum += share;
  }
  // The sum of decimal fractions may exceed 1 by rounding.
  return sum <= 1.0 + 1e-12 && options.delay >= 1 && options.garbage >= 1 &&
         options.garbage <= Impairment::kLongestFrame;
}

constexpr std::size_t indexOf(Fault fault) noexcept {
  return static_cast<std::size_t>(fault);
}

}  // namespace

Impairment::Impairment(const Options& options)
    : options_(options), random_(options.seed), heldFrames_(kMostHeld), delay_(options.delay) {
  if (!areValid(options)) {
    throw std::invalid_argument(
        "faults need shares from 0 to 1 in all, a delay of a frame or more and a little garbage");
  }
}

void Impairment::schedule(Fault fault, int howMany) noexcept {
  if (howMany > 0) scheduled_[indexOf(fault)].fetch_add(howMany, std::memory_order_relaxed);
}

void Impairment::setDelay(int frames) noexcept {
  delay_.store(std::max(frames, 1), std::memory_order_relaxed);
}

InjectedCounts Impairment::counts() const noexcept {
  InjectedCounts injected{.passed = passed_.load(std::memory_order_relaxed)};
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    injected.of[i] = counts_[i].load(std::memory_order_relaxed);
  }
  return injected;
}

int Impairment::pendingCount(Fault fault) const noexcept {
  constexpr std::int64_t kMost = 1'000'000'000;
  return static_cast<int>(
      std::min(scheduled_[indexOf(fault)].load(std::memory_order_relaxed), kMost));
}

void Impairment::countFault(Fault fault) noexcept {
  counts_[indexOf(fault)].fetch_add(1, std::memory_order_relaxed);
}

bool Impairment::hasRoomFor(Fault fault) const noexcept {
  const bool needsPlace = fault == Fault::Reorder || fault == Fault::Delay;
  return !needsPlace || held_ < heldFrames_.size();
}

std::optional<Fault> Impairment::scheduledFault() noexcept {
  for (std::size_t i = 0; i < scheduled_.size(); ++i) {
    const auto fault = static_cast<Fault>(i);
    if (scheduled_[i].load(std::memory_order_relaxed) <= 0 || !hasRoomFor(fault)) continue;
    scheduled_[i].fetch_sub(1, std::memory_order_relaxed);  // no race: only one thread takes
    return fault;
  }
  return std::nullopt;
}

std::optional<Fault> Impairment::randomFault() noexcept {
  double left = random_.uniform();
  for (std::size_t i = 0; i < options_.shares.size(); ++i) {
    left -= options_.shares[i];
    if (left >= 0.0) continue;
    const auto fault = static_cast<Fault>(i);
    return hasRoomFor(fault) ? std::optional(fault) : std::nullopt;
  }
  return std::nullopt;
}

std::optional<Fault> Impairment::nextFault() noexcept {
  if (isReordering_) return std::nullopt;
  const auto ordered = scheduledFault();
  return ordered ? ordered : randomFault();
}

Impairment::Delivery Impairment::decide(std::span<const std::uint8_t> frame) noexcept {
  passed_.fetch_add(1, std::memory_order_relaxed);
  const bool isFit = !frame.empty() && frame.size() <= kLongestFrame;
  std::optional<Fault> fault;
  if (isFit) fault = nextFault();
  if (!fault) {
    countDownHeld(true);
    return {.frame = frame};
  }
  countDownHeld(*fault == Fault::Double || *fault == Fault::Garbage);
  return impair(frame, *fault);
}

Impairment::Delivery Impairment::impair(std::span<const std::uint8_t> frame, Fault fault) noexcept {
  switch (fault) {
    case Fault::Drop:
      countFault(fault);
      return {.copies = 0};
    case Fault::Double:
      countFault(fault);
      return {.frame = frame, .copies = 2};
    case Fault::Reorder:
      hold(frame, fault, kReorderWait);
      isReordering_ = true;
      return {.copies = 0};
    case Fault::Delay:
      hold(frame, fault, delay_.load(std::memory_order_relaxed));
      return {.copies = 0};
    case Fault::Garbage:
      countFault(fault);
      return {.garbage = makeGarbage(), .frame = frame};
    case Fault::Damage:
      countFault(fault);
      return {.frame = damage(frame)};
  }
  return {.frame = frame};
}

void Impairment::countIntact() noexcept {
  passed_.fetch_add(1, std::memory_order_relaxed);
  countDownHeld(false);
}

void Impairment::hold(std::span<const std::uint8_t> frame, Fault fault, int frames) noexcept {
  HeldFrame& place = heldFrames_[held_++];
  std::copy(frame.begin(), frame.end(), place.bytes.begin());
  place.size = frame.size();
  place.left = frames;
  place.isOvertaken = false;
  place.fault = fault;
}

void Impairment::countDownHeld(bool overtakes) noexcept {
  for (std::size_t i = 0; i < held_; ++i) {
    --heldFrames_[i].left;
    heldFrames_[i].isOvertaken = heldFrames_[i].isOvertaken || overtakes;
  }
  if (overtakes) isReordering_ = false;
}

void Impairment::releaseAll() noexcept {
  for (std::size_t i = 0; i < held_; ++i) {
    if (heldFrames_[i].isOvertaken) countFault(heldFrames_[i].fault);
    heldFrames_[i].left = 0;
    heldFrames_[i].isOvertaken = false;  // already counted above
  }
  isFlushing_ = true;
  isReordering_ = false;
}

std::span<const std::uint8_t> Impairment::nextDue() noexcept {
  for (std::size_t i = 0; i < held_; ++i) {
    const HeldFrame& place = heldFrames_[i];
    if (!isFlushing_ && (place.left > 0 || !place.isOvertaken)) continue;
    if (!isFlushing_) countFault(place.fault);
    const std::size_t size = place.size;
    std::copy_n(place.bytes.begin(), size, scratch_.begin());
    std::move(
        heldFrames_.begin() + static_cast<std::ptrdiff_t>(i) + 1,
        heldFrames_.begin() + static_cast<std::ptrdiff_t>(held_),
        heldFrames_.begin() + static_cast<std::ptrdiff_t>(i));
    --held_;
    return std::span(scratch_).first(size);
  }
  isFlushing_ = false;
  return {};
}

std::uint8_t Impairment::randomByte() noexcept {
  return static_cast<std::uint8_t>(random_.bits() >> 56);
}

std::span<const std::uint8_t> Impairment::makeGarbage() noexcept {
  const auto garbage = std::span(scratch_).first(options_.garbage);
  for (std::uint8_t& byte : garbage) {
    do {
      byte = randomByte();
    } while (byte == options_.delimiter);
  }
  if (options_.delimiter) garbage.back() = *options_.delimiter;
  return garbage;
}

std::span<const std::uint8_t> Impairment::damage(std::span<const std::uint8_t> frame) noexcept {
  std::copy(frame.begin(), frame.end(), scratch_.begin());
  const auto damaged = std::span(scratch_).first(frame.size());
  std::size_t at = random_.bits() % frame.size();
  for (std::size_t i = 0; i < frame.size() && frame[at] == options_.delimiter; ++i) {
    at = (at + 1) % frame.size();
  }
  do {
    damaged[at] = randomByte();
  } while (damaged[at] == frame[at] || damaged[at] == options_.delimiter);
  return damaged;
}

}  // namespace haptics::emulators
