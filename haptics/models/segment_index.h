#pragma once

#include <stddef.h>
#include <stdint.h>

namespace haptics::models {

/// Finds the piece of a curve at a position without searching the whole curve: equal buckets over
/// its span, each with the first and the last piece that reach into it. It takes one multiplication
/// and two reads, then a bisection of the pieces in the bucket: at most log2 of their number.
///
/// Without a table it bisects the whole curve. The memory is the caller's and must outlive it.
template <typename Scalar>
struct SegmentIndex {
  const uint32_t* first = nullptr;  ///< of each bucket: the first piece; one more for the end
  uint32_t buckets = 0;
  Scalar origin{};   ///< where the first bucket begins
  Scalar perUnit{};  ///< buckets in a unit of position

  /// The bucket of @p position, which lies within the span; grows with it, rounding and all.
  constexpr uint32_t bucketOf(Scalar position) const noexcept {
    const Scalar place = (position - origin) * perUnit;
    if (!(place > Scalar{0})) return 0;
    const auto bucket = static_cast<int64_t>(place);
    return bucket < static_cast<int64_t>(buckets) ? static_cast<uint32_t>(bucket) : buckets - 1;
  }

  /// The last of @p pieces whose beginning, beginOf(piece), does not lie beyond @p position; the
  /// first where all do.
  template <typename BeginOf>
  constexpr size_t find(Scalar position, size_t pieces, BeginOf beginOf) const noexcept {
    size_t low = 0;
    size_t high = pieces - 1;
    if (first != nullptr) {
      const uint32_t bucket = bucketOf(position);
      low = first[bucket];
      high = first[bucket + 1];
    }
    while (high > low) {
      const size_t middle = high - (high - low) / 2;
      if (beginOf(middle) <= position) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }
};

}  // namespace haptics::models
