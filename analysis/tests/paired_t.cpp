#include "analysis/tests/paired_t.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "analysis/data/moments.h"
#include "analysis/numerics/student_distribution.h"

namespace analysis {
namespace {

bool isNumber(double value) {
  return std::isfinite(value);
}

std::vector<double> differencesOf(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("a pair has two values");
  if (!std::ranges::all_of(x, isNumber) || !std::ranges::all_of(y, isNumber)) {
    throw std::invalid_argument("a value is infinite or no number: it has no place in a mean");
  }
  std::vector<double> differences;
  differences.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) differences.push_back(x[i] - y[i]);
  return differences;
}

Reason whyUndefined(const Moments& differences) {
  if (differences.n == 0) return reason("no_pairs");
  if (differences.n == 1) return reason("one_pair");
  if (!differences.isConstant()) return {};
  return differences.mean.isZero() ? reason("pairs_equal") : reason("differences_same");
}

void addProbabilities(PairedTResult& result) {
  const double t = *result.t;
  const StudentDistribution law(*result.degreesOfFreedom);
  const double p = law.twoSidedP(t);
  result.p = p;
  result.log10P = law.log10TwoSidedP(t);
  result.pLess = t < 0.0 ? 0.5 * p : 1.0 - 0.5 * p;
  result.pGreater = t < 0.0 ? 1.0 - 0.5 * p : 0.5 * p;
}

void addTest(PairedTResult& result, const Moments& differences) {
  const auto n = static_cast<double>(differences.n);
  const DoubleDouble standardError = squareRoot(differences.variance / n);
  result.variance = toDouble(differences.variance, 2 * differences.exponent);
  result.standardError = toDouble(standardError, differences.exponent);
  if (differences.isConstant()) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (!differences.mean.isZero()) result.t = std::copysign(kInfinity, differences.mean.high);
    return;
  }
  result.t = (differences.mean / standardError).high;
  result.degreesOfFreedom = n - 1.0;
  addProbabilities(result);
}

}  // namespace

PairedTResult pairedTTest(std::span<const double> x, std::span<const double> y) {
  const std::vector<double> values = differencesOf(x, y);
  PairedTResult result;
  result.n = values.size();
  if (!std::ranges::all_of(values, isNumber)) {
    result.reason = reason("difference_beyond_double");
    return result;
  }

  const Moments differences = momentsOf(values);
  if (differences.n > 0) {
    result.meanDifference = toDouble(differences.mean, differences.exponent);
  }
  if (differences.n > 1) addTest(result, differences);
  result.reason = whyUndefined(differences);
  if (!result.reason.empty()) return result;

  if (!result.meanDifference || !result.variance || !result.standardError) {
    result.reason = reason("moment_beyond_double");
  }
  return result;
}

std::optional<Interval> confidenceInterval(const PairedTResult& result, double level) {
  if (!(level > 0.0 && level < 1.0)) {
    throw std::invalid_argument("a confidence level lies between 0 and 1");
  }
  if (!result.meanDifference || !result.standardError || !result.degreesOfFreedom) {
    return std::nullopt;
  }
  const StudentDistribution law(*result.degreesOfFreedom);
  const double reach = law.twoSidedQuantile(1.0 - level) * *result.standardError;
  if (!std::isfinite(std::abs(*result.meanDifference) + reach)) return std::nullopt;
  return Interval{.low = *result.meanDifference - reach, .high = *result.meanDifference + reach};
}

}  // namespace analysis
