#pragma once

#include <stddef.h>
#include <stdint.h>

namespace haptics::models {

/// Finds the piece of a curve at a position without searching the whole curve. The curve's range is
/// divided into equal buckets; a table has the first and the last piece of each. A search takes one
/// multiplication, two reads, and a bisection among the pieces of the bucket.
///
/// Without a table it bisects the whole curve. The caller owns the table, which must outlive this
/// object.
template <typename Scalar>
struct SegmentIndex {
  /// Index of the first piece of each bucket; buckets + 1 entries.
  const uint32_t* first = nullptr;
  uint32_t buckets = 0;
  Scalar origin{};   ///< position at which the first bucket begins
  Scalar perUnit{};  ///< number of buckets per unit of position

  /// The bucket of @p position, which must be within the range; monotone in spite of rounding.
  constexpr uint32_t bucketOf(Scalar position) const noexcept {
    const Scalar place = (position - origin) * perUnit;
    if (!(place > Scalar{0})) return 0;
    const auto bucket = static_cast<int64_t>(place);
    return bucket < static_cast<int64_t>(buckets) ? static_cast<uint32_t>(bucket) : buckets - 1;
  }

  /// Index of the last of @p pieces that begins, by beginOf(piece), at or before @p position; 0 if
  /// none does.
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
