#include "analysis/data/midranks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>

namespace analysis {

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
    const auto ties = static_cast<Wide>(next - first);
    ranks.tieSum += ties * ties * ties - ties;
    first = next;
  }
  return ranks;
}

}  // namespace analysis
