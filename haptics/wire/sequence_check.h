#pragma once

#include <cstdint>

namespace haptics::wire {

/// Detects lost, duplicate and late messages by the sender's sequence numbers. Counter is unsigned
/// and wraps around.
template <typename Counter>
class SequenceCheck {
 public:
  enum class Verdict {
    Fresh,    ///< newer than all before
    Doubled,  ///< a duplicate, to be ignored
    Late,     ///< overtaken by a newer one, to be ignored
    Restart,  ///< so far from the last number that the sender must have restarted
  };

  Verdict take(Counter number) noexcept {
    if (!hasAny_) return begin(number);
    const auto ahead = static_cast<Counter>(number - newest_);
    if (ahead == 0) return countDoubled();
    if (ahead <= kLargestGap) {
      lost_ += ahead - 1U;
      receivedBits_ = ahead < 64 ? receivedBits_ << ahead : 0;
      receivedBits_ |= 1U;
      newest_ = number;
      return Verdict::Fresh;
    }
    const auto behind = static_cast<Counter>(newest_ - number);
    if (behind >= 64) {
      ++restarts_;
      return begin(number);
    }
    const std::uint64_t bit = std::uint64_t{1} << behind;
    if ((receivedBits_ & bit) != 0) return countDoubled();
    receivedBits_ |= bit;
    ++late_;
    if (lost_ > 0) --lost_;  // it was counted as lost
    return Verdict::Late;
  }

  std::uint64_t lost() const noexcept { return lost_; }
  std::uint64_t duplicates() const noexcept { return doubled_; }
  std::uint64_t late() const noexcept { return late_; }
  std::uint64_t restarts() const noexcept { return restarts_; }

 private:
  static constexpr Counter kLargestGap = 1000;

  Verdict begin(Counter number) noexcept {
    const bool isFirst = !hasAny_;
    hasAny_ = true;
    newest_ = number;
    receivedBits_ = ~std::uint64_t{0};  // numbers before the first do not count as lost
    return isFirst ? Verdict::Fresh : Verdict::Restart;
  }
  Verdict countDoubled() noexcept {
    ++doubled_;
    return Verdict::Doubled;
  }

  bool hasAny_ = false;
  Counter newest_ = 0;
  std::uint64_t receivedBits_ = 0;  ///< bit i: newest − i has been received
  std::uint64_t lost_ = 0;
  std::uint64_t doubled_ = 0;
  std::uint64_t late_ = 0;
  std::uint64_t restarts_ = 0;
};

}  // namespace haptics::wire
