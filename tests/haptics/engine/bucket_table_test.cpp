#include "haptics/engine/bucket_table.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace haptics::engine {
namespace bucket_table_test {

std::size_t bySearching(const std::vector<double>& knots, double position) {
  const auto above = std::upper_bound(knots.begin(), knots.end() - 1, position);
  return above == knots.begin() ? 0 : static_cast<std::size_t>(above - knots.begin()) - 1;
}

std::size_t byIndex(const std::vector<double>& knots, const BucketTable& table, double position) {
  return table.index().find(position, knots.size() - 1, [&](std::size_t k) { return knots[k]; });
}

/// At the knots, next to them on both sides, and anywhere.
void expectAgreement(const std::vector<double>& knots, const BucketTable& table) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> anywhere(knots.front(), knots.back());
  std::vector<double> positions;
  for (const double knot : knots) {
    positions.insert(
        positions.end(), {std::nextafter(knot, -INFINITY), knot, std::nextafter(knot, INFINITY)});
  }
  for (int i = 0; i < 2000; ++i) positions.push_back(anywhere(random));
  for (const double position : positions) {
    if (position < knots.front() || position > knots.back()) continue;
    ASSERT_EQ(byIndex(knots, table, position), bySearching(knots, position)) << position;
  }
}

std::vector<double> jittered(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> gap(0.2, 1.8);
  std::vector<double> knots{-3.0};
  while (knots.size() < count) knots.push_back(knots.back() + gap(random));
  return knots;
}

/// How many comparisons the worst position takes.
int worstComparisons(const BucketTable& table) {
  const auto index = table.index();
  std::uint32_t crowd = 0;
  for (std::uint32_t i = 1; i <= index.buckets; ++i) {
    crowd = std::max(crowd, index.first[i] - index.first[i - 1]);
  }
  return std::bit_width(crowd);
}

TEST(BucketTable, FindsTheSameAsASearch) {
  for (const std::size_t count : {2U, 3U, 4U, 5U, 12U, 100U, 10'000U}) {
    const auto knots = jittered(count, static_cast<unsigned>(count));
    expectAgreement(knots, BucketTable(knots));
  }
}

TEST(BucketTable, NeedsFewComparisonsForDenseNodes) {
  // Twelve nodes over nine natural logarithms, as an adaptive choice of nodes leaves them.
  std::vector<double> knots;
  for (int i = 0; i < 12; ++i) knots.push_back(std::exp(9.0 * i / 11.0 - 9.0));
  const BucketTable table(knots);
  expectAgreement(knots, table);
  EXPECT_LE(worstComparisons(table), 3);
  EXPECT_LE(table.buckets(), 8192U);
}

TEST(BucketTable, IsBoundedForNodesDenserThanAnyTable) {
  std::vector<double> knots{0.0};
  for (int i = 1; i <= 1000; ++i) knots.push_back(i * 1e-15);
  knots.push_back(1.0);
  const BucketTable table(knots);
  expectAgreement(knots, table);
  EXPECT_EQ(table.buckets(), std::size_t{1} << 18);  // 1 MiB, and no more
  EXPECT_LE(worstComparisons(table), 10);            // log2 of what shares a bucket
}

TEST(BucketTable, IsOmittedIfTheSpanAllowsNone) {
  constexpr double kTiny = std::numeric_limits<double>::denorm_min();
  const std::vector<double> tiny{0.0, kTiny, 2 * kTiny, 3 * kTiny, 4 * kTiny};
  const BucketTable none(tiny);
  EXPECT_EQ(none.buckets(), 0U);
  expectAgreement(tiny, none);
  const std::vector<double> huge{-1e308, -1e300, 0.0, 1e300, 1e308};
  expectAgreement(huge, BucketTable(huge));
}

}  // namespace bucket_table_test
}  // namespace haptics::engine
