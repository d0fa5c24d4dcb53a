#include "analysis/tests/brown_forsythe.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/numerics/exact_arithmetic.h"
#include "analysis/tests/one_way_anova.h"

namespace analysis {
namespace {

/// @param values  at least one.
double medianOf(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  if (values.size() % 2 == 1) return values[half];
  return 0.5 * values[half - 1] + 0.5 * values[half];
}

/// Equal ones as equal numbers, in whichever group: their last digits are noise.
void tidy(std::vector<std::vector<double>>& groups) {
  std::vector<double> all;
  for (const auto& group : groups) all.insert(all.end(), group.begin(), group.end());
  const auto clean = withoutRoundingNoise(all);
  auto next = clean.begin();
  for (auto& group : groups) {
    for (double& value : group) value = *next++;
  }
}

std::vector<double> deviationsOf(const std::vector<double>& values) {
  constexpr double kQuarter = 0.25;  // so that no deviation overflows; F is the same for any scale
  const double median = kQuarter * medianOf(values);
  std::vector<double> deviations;
  deviations.reserve(values.size());
  for (const double value : values) deviations.push_back(std::abs(kQuarter * value - median));
  return deviations;
}

bool isFinite(double value) {
  return std::isfinite(value);
}

}  // namespace

BrownForsytheResult brownForsytheTest(std::span<const std::vector<double>> groups) {
  std::vector<std::vector<double>> deviations;
  for (const auto& values : groups) {
    if (!std::ranges::all_of(values, isFinite)) {
      throw std::invalid_argument("a value is infinite or no number: it has no place in a median");
    }
    deviations.push_back(values.empty() ? values : deviationsOf(values));
  }

  tidy(deviations);
  const OneWayAnovaResult anova = oneWayAnova(deviations);
  BrownForsytheResult result;
  result.degreesOfFreedom1 = anova.degreesOfFreedom1;
  result.degreesOfFreedom2 = anova.degreesOfFreedom2;
  result.f = anova.f;
  result.p = anova.p;
  result.log10P = anova.log10P;
  if (result.p) return result;

  result.reason = anova.degreesOfFreedom1 ? reason("equally_far_from_median") : anova.reason;
  return result;
}

}  // namespace analysis
