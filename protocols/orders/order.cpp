#include "protocols/orders/order.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "protocols/orders/random_stream.h"

namespace protocols {
namespace {

Row identity(int k) {
  Row row(static_cast<std::size_t>(k));
  std::iota(row.begin(), row.end(), 0);
  return row;
}

Row shifted(const Row& row, int by) {
  Row result;
  for (const int value : row) result.push_back((value + by) % static_cast<int>(row.size()));
  return result;
}

/// 0, 1, k−1, 2, k−2, …: neighbours differ by every amount once.
Row williamsRow(int k) {
  Row row{0};
  for (int low = 1, high = k - 1; static_cast<int>(row.size()) < k;) {
    row.push_back(low++);
    if (static_cast<int>(row.size()) < k) row.push_back(high--);
  }
  return row;
}

std::vector<Row> williams(int k) {
  std::vector<Row> rows;
  for (int i = 0; i < k; ++i) rows.push_back(shifted(williamsRow(k), i));
  if (k % 2 == 0) return rows;
  for (int i = 0; i < k; ++i) {
    Row mirrored = rows[static_cast<std::size_t>(i)];
    std::reverse(mirrored.begin(), mirrored.end());
    rows.push_back(std::move(mirrored));
  }
  return rows;
}

std::vector<Row> permutations(int k) {
  std::vector<Row> rows;
  Row row = identity(k);
  do rows.push_back(row);
  while (std::next_permutation(row.begin(), row.end()));
  return rows;
}

}  // namespace

std::vector<Row> rowsOf(OrderType type, int k) {
  std::vector<Row> rows;
  switch (type) {
    case OrderType::Fixed:
      return {identity(k)};
    case OrderType::LatinSquare:
      for (int i = 0; i < k; ++i) rows.push_back(shifted(identity(k), i));
      return rows;
    case OrderType::BalancedLatinSquare:
      return k < 2 ? permutations(k) : williams(k);
    case OrderType::Complete:
      return permutations(k);
    case OrderType::Random:
    case OrderType::Reversed:
      return {};
  }
  return {};
}

Row orderFor(
    OrderType type, int k, std::uint64_t seed, std::uint64_t slot, std::string_view purpose) {
  const auto rows = rowsOf(type, k);
  if (rows.empty()) {
    Row row = identity(k);
    RandomStream(seed, slot, "order/" + std::string(purpose)).shuffle(row);
    return row;
  }
  Row sequence = identity(static_cast<int>(rows.size()));
  RandomStream(seed, slot / rows.size(), "rows/" + std::string(purpose)).shuffle(sequence);
  return rows[static_cast<std::size_t>(sequence[slot % rows.size()])];
}

}  // namespace protocols
