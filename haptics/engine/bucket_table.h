#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "haptics/models/segment_index.h"

namespace haptics::engine {

/// The memory behind a models::SegmentIndex: built once, before the hand is on the tool.
///
/// It takes two buckets a piece, and goes on doubling them while more than four nodes share one,
/// up to 2^18 (1 MiB): crowded nodes beyond that are bisected, in at most log2 of their number.
class BucketTable {
 public:
  /// No table: every search is a bisection.
  BucketTable() = default;

  /// @param knots  where the pieces begin and the last one ends, strictly increasing and finite;
  ///               one more than there are pieces. Two pieces or fewer need no table.
  explicit BucketTable(std::span<const double> knots);

  models::SegmentIndex<double> index() const noexcept;

  std::size_t buckets() const noexcept { return first_.empty() ? 0 : first_.size() - 1; }
  std::size_t bytes() const noexcept { return first_.size() * sizeof(first_[0]); }

 private:
  bool fill(std::span<const double> knots, std::uint32_t buckets);

  models::SegmentIndex<double> shape_;
  std::vector<std::uint32_t> first_;
};

}  // namespace haptics::engine
