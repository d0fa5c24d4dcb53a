#include "analysis/hypothesis_tests/adjustment.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace analysis {
namespace {

using SortedPValues = std::vector<double>;  // from the smallest to the largest

/// Computes the adjusted value of the i-th smallest of m p values, before the adjusted values are
/// made monotonic.
using StepFormula = std::function<double(double p, double i, double m)>;

SortedPValues stepDown(SortedPValues p, const StepFormula& step) {
  double largest = 0.0;
  for (std::size_t j = 0; j < p.size(); ++j) {
    const double own = step(p[j], static_cast<double>(j + 1), static_cast<double>(p.size()));
    largest = std::max(largest, std::min(1.0, own));
    p[j] = largest;
  }
  return p;
}

SortedPValues stepUp(SortedPValues p, const StepFormula& step) {
  double smallest = 1.0;
  for (std::size_t j = p.size(); j-- > 0;) {
    const double own = step(p[j], static_cast<double>(j + 1), static_cast<double>(p.size()));
    smallest = std::min(smallest, own);
    p[j] = smallest;
  }
  return p;
}

double pTimesRemaining(double p, double i, double m) {
  return (m - i + 1.0) * p;
}

double sidak(double p, double i, double m) {
  return -std::expm1((m - i + 1.0) * std::log1p(-p));
}

/// Simes' p of the @p count largest p values, if the smallest of them is left out: the minimum of
/// count · p / rank over the ranks from 2.
double simesWithoutSmallest(const SortedPValues& p, std::size_t count) {
  double least = 1.0;
  const std::size_t first = p.size() - count + 1;
  for (std::size_t rank = 2; rank <= count; ++rank) {
    const double own = static_cast<double>(count) * p[first + rank - 2] / static_cast<double>(rank);
    least = std::min(least, own);
  }
  return least;
}

/// The algorithm of Wright 1992. Of all subsets of j hypotheses that contain the i-th one, only the
/// subset whose other p values are the largest has to be tested.
SortedPValues hommel(const SortedPValues& p) {
  const std::size_t m = p.size();
  SortedPValues adjusted = p;
  for (std::size_t j = 2; j <= m; ++j) {
    const double others = simesWithoutSmallest(p, j);
    const std::size_t firstOfLargest = m - j + 1;  // the j − 1 largest begin here
    const double ownOfSmaller = static_cast<double>(j) * p[firstOfLargest - 1];
    for (std::size_t i = 0; i < m; ++i) {
      const double own = i < firstOfLargest ? static_cast<double>(j) * p[i] : ownOfSmaller;
      adjusted[i] = std::max(adjusted[i], std::min(own, others));
    }
  }
  return adjusted;
}

double harmonicSum(std::size_t m) {
  double sum = 0.0;
  for (std::size_t i = m; i > 0; --i) sum += 1.0 / static_cast<double>(i);
  return sum;
}

SortedPValues adjusted(const SortedPValues& p, Adjustment method) {
  const auto benjaminiHochberg = [](double own, double i, double m) { return own * m / i; };
  const auto benjaminiYekutieli = [c = harmonicSum(p.size())](double own, double i, double m) {
    return c * own * m / i;
  };
  switch (method) {
    case Adjustment::Bonferroni:
      return stepDown(p, [](double own, double /*i*/, double m) { return own * m; });
    case Adjustment::Holm:
      return stepDown(p, pTimesRemaining);
    case Adjustment::Hochberg:
      return stepUp(p, pTimesRemaining);
    case Adjustment::Hommel:
      return hommel(p);
    case Adjustment::BenjaminiHochberg:
      return stepUp(p, benjaminiHochberg);
    case Adjustment::BenjaminiYekutieli:
      return stepUp(p, benjaminiYekutieli);
    case Adjustment::HolmSidak:
      return stepDown(p, sidak);
  }
  throw std::invalid_argument("there is no such adjustment");
}

bool isProbability(double p) {
  return p >= 0.0 && p <= 1.0;
}

}  // namespace

std::string_view nameOf(Adjustment method) noexcept {
  switch (method) {
    case Adjustment::Bonferroni:
      return "bonferroni";
    case Adjustment::Holm:
      return "holm";
    case Adjustment::Hochberg:
      return "hochberg";
    case Adjustment::Hommel:
      return "hommel";
    case Adjustment::BenjaminiHochberg:
      return "bh";
    case Adjustment::BenjaminiYekutieli:
      return "by";
    case Adjustment::HolmSidak:
      return "holm-sidak";
  }
  return "";
}

std::size_t definedCount(std::span<const std::optional<double>> pValues) {
  const auto count = std::ranges::count_if(pValues, [](const auto& p) { return p.has_value(); });
  return static_cast<std::size_t>(count);
}

std::vector<std::optional<double>> adjust(
    std::span<const std::optional<double>> pValues, Adjustment method) {
  std::vector<std::size_t> order;  // indices of the p values that are defined
  for (std::size_t i = 0; i < pValues.size(); ++i) {
    if (!pValues[i]) continue;
    if (!isProbability(*pValues[i])) {
      throw std::invalid_argument("a p value lies between 0 and 1");
    }
    order.push_back(i);
  }
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return *pValues[i]; });

  SortedPValues sorted;
  for (const std::size_t i : order) sorted.push_back(*pValues[i]);
  const SortedPValues results = adjusted(sorted, method);

  std::vector<std::optional<double>> all(pValues.size());
  for (std::size_t i = 0; i < order.size(); ++i) all[order[i]] = results[i];
  return all;
}

double alphaPerTest(double alpha, std::size_t tests) {
  if (!(alpha > 0.0 && alpha < 1.0)) throw std::invalid_argument("alpha lies between 0 and 1");
  if (tests == 0) throw std::invalid_argument("there are no tests to share alpha");
  return alpha / static_cast<double>(tests);
}

}  // namespace analysis
