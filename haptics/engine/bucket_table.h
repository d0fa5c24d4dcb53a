#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "haptics/models/segment_index.h"

namespace haptics::engine {

/// Builds and owns the table of a models::SegmentIndex. Not to be built in the tick.
///
/// The table starts with two buckets per piece and doubles their number, up to 2^18 (1 MiB), while
/// more than four nodes share a bucket. Within a bucket the search bisects.
class BucketTable {
 public:
  /// An empty table: every search bisects all pieces.
  BucketTable() = default;

  /// @param knots  the begin of every piece and the end of the last one, strictly increasing and
  ///               finite. For two pieces or fewer the table stays empty.
  explicit BucketTable(std::span<const double> knots);

  models::SegmentIndex<double> index() const noexcept;

  std::size_t buckets() const noexcept {
    return firstPieces_.empty() ? 0 : firstPieces_.size() - 1;
  }
  std::size_t bytes() const noexcept { return firstPieces_.size() * sizeof(firstPieces_[0]); }

 private:
  bool fill(std::span<const double> knots, std::uint32_t buckets);

  models::SegmentIndex<double> index_;
  std::vector<std::uint32_t> firstPieces_;
};

}  // namespace haptics::engine
