#include "analysis/numerics/tail_probabilities.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <boost/math/special_functions/gamma.hpp>

namespace analysis {
namespace {

constexpr double kAsymptoticLimit = 30.0;  // standard deviations

/// ln P(Z ≥ x) for x > 30: Laplace's asymptotic series, Σ (−1)ⁿ (2n − 1)!! / x²ⁿ (Abramowitz &
/// Stegun 7.1.23). The first term left out is below 1e-20.
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

/// ln Q(a, x) for x far above a: Legendre's continued fraction (the even part of
/// Abramowitz & Stegun 6.5.31), evaluated from its end.
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

constexpr double kStep = 1.0 / 32.0;
constexpr double kIntegrationLimit = 12.0;  // |z| > 12 has a probability below 1e-30

/// ln of φ(z) [Φ(z)^m − (Φ(z) − Φ(z − q))^m].
double logIntegrand(double z, double q, double m) {
  constexpr double kNegligible = -40.0;  // e^−40 is negligible beside 1
  const double logPhi = -0.5 * z * z - 0.5 * std::log(2.0 * std::numbers::pi);
  const double logBelow = logNormalCdf(z);
  // ln of the share of Φ(z) that lies more than q below z.
  const double logShare = std::min(0.0, logNormalCdf(z - q) - logBelow);
  // Φ(z)^m − (Φ(z) − Φ(z − q))^m = Φ(z)^m (1 − (1 − share)^m). For a tiny share, the last factor is
  // m · share.
  const double logLoss = logShare < kNegligible
                             ? std::log(m) + logShare
                             : std::log(-std::expm1(m * std::log1p(-std::exp(logShare))));
  return logPhi + m * logBelow + logLoss;
}

/// ln P(Q ≥ q)
double logUpperTail(double q, std::size_t k) {
  const auto m = static_cast<double>(k - 1);
  const auto first = static_cast<long>(std::floor(-kIntegrationLimit / kStep));
  const auto last = static_cast<long>(std::ceil((q + kIntegrationLimit) / kStep));
  std::vector<double> logs;
  for (long i = first; i <= last; ++i) {
    logs.push_back(logIntegrand(static_cast<double>(i) * kStep, q, m));
  }
  // Relative to the largest term, so that no exponential underflows.
  const double largest = *std::ranges::max_element(logs);
  double sum = 0.0;
  for (const double log : logs) sum += std::exp(log - largest);
  return std::min(0.0, largest + std::log(sum * kStep * static_cast<double>(k)));
}

void requireValidRange(double q, std::size_t k) {
  constexpr std::size_t kMostGroups = 10'000;
  constexpr double kLargest = 1e5;
  if (!(q >= 0.0 && q <= kLargest))
    throw std::invalid_argument("a range lies between 0 and 100000");
  if (k < 2 || k > kMostGroups) throw std::invalid_argument("a range is that of 2 to 10000 values");
}

}  // namespace

double normalTwoSidedP(double z) {
  return std::erfc(std::abs(z) / std::numbers::sqrt2);
}

double normalUpperP(double z) {
  return 0.5 * std::erfc(z / std::numbers::sqrt2);
}

double log10NormalTwoSidedP(double z) {
  const double distance = std::abs(z);
  if (distance > kAsymptoticLimit) {
    return (logFarNormalTail(distance) + std::numbers::ln2) / std::numbers::ln10;
  }
  // Near z = 0 the logarithm of a p near one would lose digits; that of 1 − erf does not.
  if (distance < 0.5)
    return std::log1p(-std::erf(distance / std::numbers::sqrt2)) / std::numbers::ln10;
  return std::log10(normalTwoSidedP(z));
}

double logNormalCdf(double x) {
  if (x < -kAsymptoticLimit) return logFarNormalTail(-x);
  if (x > 0.0) return std::log1p(-normalUpperP(x));
  return std::log(normalUpperP(-x));
}

void requireConfidenceLevel(double level) {
  if (!(level > 0.0 && level < 1.0)) {
    throw std::invalid_argument("a confidence level lies between 0 and 1");
  }
}

double normalTwoSidedQuantile(double level) {
  requireConfidenceLevel(level);
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

double chiSquaredUpperQuantile(double p, double degreesOfFreedom) {
  const boost::math::chi_squared law(degreesOfFreedom);
  return boost::math::quantile(boost::math::complement(law, p));
}

double studentizedRangeP(double q, std::size_t k) {
  requireValidRange(q, k);
  return std::exp(logUpperTail(q, k));
}

double log10StudentizedRangeP(double q, std::size_t k) {
  requireValidRange(q, k);
  return logUpperTail(q, k) / std::numbers::ln10;
}

}  // namespace analysis
