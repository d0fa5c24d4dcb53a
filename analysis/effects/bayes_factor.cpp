#include "analysis/effects/bayes_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <boost/math/quadrature/trapezoidal.hpp>

namespace analysis {
namespace {

/// The logarithm of the integrand over u = ln g. Numerator and denominator are combined before the
/// logarithm is taken, so that neither overflows for a large t.
class LogIntegrand {
 public:
  LogIntegrand(double t, double degreesOfFreedom, double effectiveN, double priorScale)
      : power_(0.5 * (degreesOfFreedom + 1.0)), width_(effectiveN * priorScale * priorScale) {
    const double root = t / std::sqrt(degreesOfFreedom);
    inverseOfX_ = 1.0 / root / root;
  }

  /// With a = 1 + N g r² and x = t²/ν, (1 + x) / (1 + x/a) = 1 + (a − 1) / (1 + a/x).
  double operator()(double u) const {
    const double g = std::exp(u);
    const double gain = width_ * g;
    const double likelihood = power_ * std::log1p(gain / (1.0 + (1.0 + gain) * inverseOfX_));
    const double prior = -0.5 * u - 0.5 / g - 0.5 * std::log(2.0 * std::numbers::pi);
    return likelihood - 0.5 * std::log1p(gain) + prior;
  }

 private:
  double power_;
  double width_;
  double inverseOfX_ = 0.0;
};

/// The range of u where the integrand is not negligible, and the maximum of its logarithm.
struct Support {
  double low = 0.0;
  double high = 0.0;
  double peak = 0.0;
};

/// Searches in steps of 1/8 of u for the peak, and from either end for the first value that is not
/// negligible compared with the peak.
Support supportOf(const LogIntegrand& logIntegrand, double farthestU) {
  constexpr double kStep = 0.125;
  constexpr double kNegligible = 45.0;  // e^−45 = 3e-20
  // At u = −8 the prior's factor e^(−1/(2g)) is e^(−e^8 / 2) = 1e-647.
  constexpr double kLowestU = -8.0;
  Support support{.low = kLowestU, .high = farthestU, .peak = logIntegrand(kLowestU)};
  for (double u = kLowestU; u < farthestU; u += kStep) {
    support.peak = std::max(support.peak, logIntegrand(u));
  }
  const double floor = support.peak - kNegligible;
  while (support.low < farthestU && logIntegrand(support.low) < floor) support.low += kStep;
  while (support.high > support.low && logIntegrand(support.high) < floor) support.high -= kStep;
  support.low -= kStep;
  support.high += kStep;
  return support;
}

void requireValidArguments(
    double t, double degreesOfFreedom, double effectiveN, double priorScale) {
  const auto isPositive = [](double number) { return number > 0.0 && std::isfinite(number); };
  if (!std::isfinite(t)) throw std::invalid_argument("a Bayes factor needs a finite t");
  if (!isPositive(degreesOfFreedom) || !isPositive(effectiveN) || !isPositive(priorScale)) {
    throw std::invalid_argument(
        "a Bayes factor needs degrees of freedom, a sample size and a prior scale above 0");
  }
}

BayesFactor undefinedBayesFactor(double priorScale, Reason why) {
  BayesFactor result;
  result.priorScale = priorScale;
  result.reason = std::move(why);
  return result;
}

}  // namespace

BayesFactor jzsBayesFactor(
    double t, double degreesOfFreedom, double effectiveN, double priorScale) {
  requireValidArguments(t, degreesOfFreedom, effectiveN, priorScale);
  constexpr double kLargestT = 1e100;
  if (std::abs(t) > kLargestT) return undefinedBayesFactor(priorScale, reason("beyond_1e100"));

  const LogIntegrand logIntegrand(t, degreesOfFreedom, effectiveN, priorScale);
  constexpr double kTailLength = 60.0;  // beyond the peak, the integrand falls at least as e^(−u)
  const double farthestU = kTailLength + 2.0 * std::log1p(std::abs(t)) +
                           2.0 * std::abs(std::log(priorScale)) + std::abs(std::log(effectiveN));
  const Support support = supportOf(logIntegrand, farthestU);

  // The trapezoidal rule converges exponentially, because the integrand vanishes smoothly at both
  // ends.
  constexpr double kTolerance = 1e-14;
  constexpr int kRefinements = 18;
  const double integral = boost::math::quadrature::trapezoidal(
      [&](double u) { return std::exp(logIntegrand(u) - support.peak); },
      support.low,
      support.high,
      kTolerance,
      kRefinements);

  BayesFactor result;
  result.priorScale = priorScale;
  const double logFactor = support.peak + std::log(integral);
  const double factor = std::exp(logFactor);
  result.log10Bf10 = logFactor / std::numbers::ln10;
  if (std::isnormal(factor)) result.bf10 = factor;
  if (!result.bf10) result.reason = reason("bayes_factor_beyond_double");
  return result;
}

BayesFactor jzsBayesFactor(
    const StudentResult& test, std::uint64_t n1, std::uint64_t n2, double priorScale) {
  if (!test.t || !test.degreesOfFreedom || !std::isfinite(*test.t)) {
    return undefinedBayesFactor(priorScale, reason("students_t_undefined"));
  }
  const auto first = static_cast<double>(n1);
  const auto second = static_cast<double>(n2);
  return jzsBayesFactor(
      *test.t, *test.degreesOfFreedom, first * second / (first + second), priorScale);
}

BayesFactor jzsBayesFactor(const PairedTResult& test, double priorScale) {
  if (!test.t || !test.degreesOfFreedom) return undefinedBayesFactor(priorScale, test.reason);
  return jzsBayesFactor(*test.t, *test.degreesOfFreedom, static_cast<double>(test.n), priorScale);
}

}  // namespace analysis
