#include "analysis/adjustment.h"

#include <algorithm>
#include <stdexcept>

namespace analysis {
namespace {

double bonferroni(double p, std::size_t tests) {
  return std::min(1.0, p * static_cast<double>(tests));
}

bool isProbability(double p) {
  return p >= 0.0 && p <= 1.0;
}

}  // namespace

std::size_t definedCount(std::span<const std::optional<double>> pValues) {
  const auto count = std::ranges::count_if(pValues, [](const auto& p) { return p.has_value(); });
  return static_cast<std::size_t>(count);
}

std::vector<std::optional<double>> adjust(
    std::span<const std::optional<double>> pValues, Adjustment /*method: there is one as yet*/) {
  const std::size_t tests = definedCount(pValues);
  std::vector<std::optional<double>> adjusted;
  adjusted.reserve(pValues.size());
  for (const auto& p : pValues) {
    if (p && !isProbability(*p)) throw std::invalid_argument("a p value lies between 0 and 1");
    adjusted.push_back(p ? std::optional(bonferroni(*p, tests)) : std::nullopt);
  }
  return adjusted;
}

double alphaPerTest(double alpha, std::size_t tests) {
  if (!(alpha > 0.0 && alpha < 1.0)) throw std::invalid_argument("alpha lies between 0 and 1");
  if (tests == 0) throw std::invalid_argument("there are no tests to share alpha");
  return alpha / static_cast<double>(tests);
}

}  // namespace analysis
