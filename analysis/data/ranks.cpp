#include "analysis/data/ranks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>

namespace analysis {
namespace {

std::vector<double> sorted(std::span<const double> values) {
  std::vector<double> result(values.begin(), values.end());
  for (const double value : result) {
    if (!std::isfinite(value)) {
      throw std::invalid_argument("a value is infinite or no number: it has no rank");
    }
  }
  std::ranges::sort(result);
  return result;
}

}  // namespace

Midranks midranksOf(std::span<const double> values) {
  for (const double value : values) {
    if (!std::isfinite(value)) {
      throw std::invalid_argument("a value is infinite or no number: it has no rank");
    }
  }
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return values[i]; });

  Midranks ranks;
  ranks.doubled.resize(values.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t next = first;
    while (next < order.size() && values[order[next]] == values[order[first]]) ++next;
    for (std::size_t i = first; i < next; ++i) ranks.doubled[order[i]] = first + 1 + next;
    const auto ties = static_cast<Int128>(next - first);
    ranks.tieSum += ties * ties * ties - ties;
    first = next;
  }
  return ranks;
}

TiedGroups tiedGroupsOf(std::span<const double> group1, std::span<const double> group2) {
  const auto first = sorted(group1);
  const auto second = sorted(group2);
  TiedGroups groups{.n1 = first.size(), .n2 = second.size(), .values = {}};
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < first.size() || j < second.size()) {
    const bool isFirst = j == second.size() || (i < first.size() && first[i] <= second[j]);
    const double value = isFirst ? first[i] : second[j];
    TiedValue tied;
    for (; i < first.size() && first[i] == value; ++i) ++tied.first;
    for (; j < second.size() && second[j] == value; ++j) ++tied.second;
    groups.values.push_back(tied);
  }
  return groups;
}

Placements placementsOf(const TiedGroups& groups) {
  if (groups.areTooLargeForExactRanks())
    throw std::invalid_argument("the groups are too large to rank");
  Placements result;
  Int128 below1 = 0;
  Int128 below2 = 0;
  for (const auto& value : groups.values) {
    const auto first = static_cast<Int128>(value.first);
    const auto second = static_cast<Int128>(value.second);
    const Int128 inSecond = 2 * below2 + second;
    const Int128 inFirst = 2 * below1 + first;
    const Int128 ties = first + second;
    result.sum1 += first * inSecond;
    result.sum2 += second * inFirst;
    result.squares1 += first * inSecond * inSecond;
    result.squares2 += second * inFirst * inFirst;
    result.equalPairs += first * second;
    result.tieSum += ties * ties * ties - ties;
    below1 += first;
    below2 += second;
  }
  return result;
}

}  // namespace analysis
