#include "haptics/timing/clock_statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace haptics::timing {
namespace {
constexpr double kLeastLateness = 1.0 / 16.0;  // [µs]; the first bin holds everything below
}

int LatenessHistogram::binOf(double lateness) noexcept {
  if (!(lateness > kLeastLateness)) return 0;
  int exponent = 0;
  // Octave and bin from the binary exponent, which avoids a logarithm in the tick.
  const double mantissa = std::frexp(lateness / kLeastLateness, &exponent);  // in [0.5, 1)
  const int bin =
      (exponent - 1) * kBinsPerOctave + static_cast<int>((mantissa - 0.5) * 2 * kBinsPerOctave);
  return std::min(bin, kBinsPerOctave * kOctaves - 1);
}

double LatenessHistogram::upperEdgeOf(int bin) noexcept {
  const int octave = bin / kBinsPerOctave;
  const double part = static_cast<double>(bin % kBinsPerOctave + 1) / kBinsPerOctave;
  return std::ldexp(kLeastLateness * (1.0 + part), octave);
}

void LatenessHistogram::add(double lateness) noexcept {
  const double late = lateness > 0.0 ? lateness : 0.0;
  ++bins_[static_cast<std::size_t>(binOf(late))];
  ++count_;
  largest_ = std::max(largest_, late);
}

double LatenessHistogram::quantile(double q) const noexcept {
  if (count_ == 0) return 0.0;
  const auto rank = static_cast<std::uint64_t>(std::ceil(q * static_cast<double>(count_)));
  std::uint64_t seen = 0;
  for (int bin = 0; bin < kBinsPerOctave * kOctaves; ++bin) {
    seen += bins_[static_cast<std::size_t>(bin)];
    if (seen >= std::max<std::uint64_t>(rank, 1)) return std::min(upperEdgeOf(bin), largest_);
  }
  return largest_;
}

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
    // After a pause, skip the empty windows at once.
    if (time - windowEnd_ > 4 * kWindow) windowEnd_ += (time - windowEnd_) / kWindow * kWindow;
  }
  // The transport of a message can only add delay. So the least delay of a window is the best
  // estimate of the difference of the clocks; the drift is the slope of a line through the windows.
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
