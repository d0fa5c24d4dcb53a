#include "haptics/timing/clock_drift.h"

#include <limits>

namespace haptics::timing {

void ClockDrift::add(std::int64_t device, std::int64_t host) noexcept {
  if (!hasAny_) {
    hasAny_ = true;
    firstDevice_ = device;
    offset_ = host - device;
    windowEnd_ = kWindow;
    leastDelay_ = std::numeric_limits<std::int64_t>::max();
  }
  const std::int64_t time = device - firstDevice_;
  while (time >= windowEnd_) {
    closeWindow();
    windowEnd_ += kWindow;
    // After a pause there is nothing to close; catch up in one go.
    if (time - windowEnd_ > 4 * kWindow) windowEnd_ += (time - windowEnd_) / kWindow * kWindow;
  }
  const std::int64_t delay = host - device - offset_;
  if (delay < leastDelay_) {
    leastDelay_ = delay;
    leastTime_ = time;
  }
}

void ClockDrift::closeWindow() noexcept {
  if (leastDelay_ == std::numeric_limits<std::int64_t>::max()) return;
  const double x = 1e-9 * static_cast<double>(leastTime_);
  const double y = 1e-3 * static_cast<double>(leastDelay_);
  sumX_ += x;
  sumY_ += y;
  sumXX_ += x * x;
  sumXY_ += x * y;
  ++count_;
  leastDelay_ = std::numeric_limits<std::int64_t>::max();
}

std::optional<double> ClockDrift::partsPerMillion() const noexcept {
  if (count_ < 3) return std::nullopt;
  const auto n = static_cast<double>(count_);
  const double spread = n * sumXX_ - sumX_ * sumX_;
  if (!(spread > 0.0)) return std::nullopt;
  return (n * sumXY_ - sumX_ * sumY_) / spread;  // [µs/s]
}

}  // namespace haptics::timing
