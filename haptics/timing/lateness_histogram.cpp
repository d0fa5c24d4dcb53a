#include "haptics/timing/lateness_histogram.h"

#include <algorithm>
#include <cmath>

namespace haptics::timing {
namespace {
constexpr double kLeast = 1.0 / 16.0;  // [µs]: the first bin takes everything below
}

int LatenessHistogram::binOf(double lateness) noexcept {
  if (!(lateness > kLeast)) return 0;
  int exponent = 0;
  const double mantissa = std::frexp(lateness / kLeast, &exponent);  // in [0.5, 1)
  const int bin = (exponent - 1) * kPerOctave + static_cast<int>((mantissa - 0.5) * 2 * kPerOctave);
  return std::min(bin, kPerOctave * kOctaves - 1);
}

double LatenessHistogram::upperEdgeOf(int bin) noexcept {
  const int octave = bin / kPerOctave;
  const double part = static_cast<double>(bin % kPerOctave + 1) / kPerOctave;
  return std::ldexp(kLeast * (1.0 + part), octave);
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
  for (int bin = 0; bin < kPerOctave * kOctaves; ++bin) {
    seen += bins_[static_cast<std::size_t>(bin)];
    if (seen >= std::max<std::uint64_t>(rank, 1)) return std::min(upperEdgeOf(bin), largest_);
  }
  return largest_;
}

}  // namespace haptics::timing
