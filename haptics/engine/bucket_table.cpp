#include "haptics/engine/bucket_table.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace haptics::engine {
namespace {

constexpr std::uint32_t kMostBuckets = 1U << 18;
constexpr std::uint32_t kBucketsPerPiece =
    2;  // initial buckets per piece; more would need more cache
constexpr std::uint32_t kMostKnotsPerBucket = 4;

}  // namespace

BucketTable::BucketTable(std::span<const double> knots) {
  constexpr std::size_t kTooFewToSearch = 4;
  if (knots.size() < kTooFewToSearch) return;
  const auto pieces = static_cast<std::uint32_t>(knots.size() - 1);
  std::uint32_t buckets = std::min(std::bit_ceil(kBucketsPerPiece * pieces), kMostBuckets);
  while (!fill(knots, buckets) && buckets < kMostBuckets) buckets *= 2;
}

/// Fills the table with @p buckets buckets; leaves it empty if the knots' range is too small to
/// divide. Returns false if more than kMostKnotsPerBucket nodes share a bucket.
bool BucketTable::fill(std::span<const double> knots, std::uint32_t buckets) {
  // Infinite for a subnormal range.
  const double perUnit = buckets / (knots.back() - knots.front());
  if (!std::isfinite(perUnit) || !(perUnit > 0.0)) {
    firstPieces_.clear();
    return true;
  }
  index_ = {.buckets = buckets, .origin = knots.front(), .perUnit = perUnit};
  // firstPieces_[b] is the last piece that begins in a bucket before b: that piece extends into b.
  firstPieces_.assign(buckets + 1U, 0);
  const auto pieces = static_cast<std::uint32_t>(knots.size() - 1);
  for (std::uint32_t piece = 1; piece < pieces; ++piece) {
    firstPieces_[index_.bucketOf(knots[piece]) + 1U] = piece;
  }
  std::uint32_t mostPerBucket = 0;
  for (std::uint32_t bucket = 1; bucket <= buckets; ++bucket) {
    firstPieces_[bucket] = std::max(firstPieces_[bucket], firstPieces_[bucket - 1]);
    mostPerBucket = std::max(mostPerBucket, firstPieces_[bucket] - firstPieces_[bucket - 1]);
  }
  return mostPerBucket <= kMostKnotsPerBucket;
}

models::SegmentIndex<double> BucketTable::index() const noexcept {
  if (firstPieces_.empty()) return {};
  auto index = index_;
  index.first = firstPieces_.data();
  return index;
}

}  // namespace haptics::engine
