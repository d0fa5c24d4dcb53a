#include "analysis/numerics/tail_probabilities.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <boost/math/special_functions/erf.hpp>
#include <boost/math/special_functions/gamma.hpp>

namespace analysis {
namespace {

constexpr double kFarOut = 30.0;  // standard deviations

/// ln P(Z ≥ x) for x far out: Laplace's asymptotic series, Σ (−1)ⁿ (2n − 1)!! / x²ⁿ.
double logFarNormalTail(double x) {
  constexpr int kTerms = 9;
  double series = 0.0;
  double term = 1.0;
  for (int n = 1; n <= kTerms; ++n) {
    term *= -(2.0 * n - 1.0) / (x * x);
    series += term;
  }
  return -0.5 * x * x - 0.5 * std::log(2.0 * std::numbers::pi) - std::log(x) + std::log1p(series);
}

/// ln Q(a, x) for x far above a: Legendre's continued fraction, from its end.
double logFarGammaTail(double a, double x) {
  constexpr int kTerms = 300;
  double fraction = x + 2.0 * kTerms + 1.0 - a;
  for (int n = kTerms; n > 0; --n) {
    fraction = x + 2.0 * n - 1.0 - a - n * (n - a) / fraction;
  }
  return -x + a * std::log(x) - boost::math::lgamma(a) - std::log(fraction);
}

void requireChiSquared(double x, double degreesOfFreedom) {
  if (!(x >= 0.0) || !std::isfinite(x)) throw std::invalid_argument("chi-squared is not negative");
  if (!(degreesOfFreedom > 0.0)) throw std::invalid_argument("degrees of freedom are positive");
}

}  // namespace

double normalTwoSidedP(double z) {
  return std::erfc(std::abs(z) / std::numbers::sqrt2);
}

double log10NormalTwoSidedP(double z) {
  const double distance = std::abs(z);
  if (distance > kFarOut) {
    return (logFarNormalTail(distance) + std::numbers::ln2) / std::numbers::ln10;
  }
  if (distance < 0.5)
    return std::log1p(-std::erf(distance / std::numbers::sqrt2)) / std::numbers::ln10;
  return std::log10(normalTwoSidedP(z));
}

double logNormalCdf(double x) {
  if (x < -kFarOut) return logFarNormalTail(-x);
  if (x > 0.0) return std::log1p(-0.5 * std::erfc(x / std::numbers::sqrt2));
  return std::log(0.5 * std::erfc(-x / std::numbers::sqrt2));
}

double normalTwoSidedQuantile(double level) {
  if (!(level > 0.0 && level < 1.0)) {
    throw std::invalid_argument("a confidence level lies between 0 and 1");
  }
  return std::numbers::sqrt2 * boost::math::erf_inv(level);
}

double chiSquaredP(double x, double degreesOfFreedom) {
  requireChiSquared(x, degreesOfFreedom);
  return boost::math::gamma_q(0.5 * degreesOfFreedom, 0.5 * x);
}

double log10ChiSquaredP(double x, double degreesOfFreedom) {
  const double p = chiSquaredP(x, degreesOfFreedom);
  if (p > kSmallestExactP) return std::log10(p);
  return logFarGammaTail(0.5 * degreesOfFreedom, 0.5 * x) / std::numbers::ln10;
}

}  // namespace analysis
