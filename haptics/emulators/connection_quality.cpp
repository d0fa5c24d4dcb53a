#include "haptics/emulators/connection_quality.h"

#include <algorithm>
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

void ConnectionQuality::answered(double latency) noexcept {
  add(std::max(latency, 0.0));
}

void ConnectionQuality::missed() noexcept {
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

}  // namespace haptics::emulators
