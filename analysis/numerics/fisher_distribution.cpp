#include "analysis/numerics/fisher_distribution.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include "analysis/numerics/tail_probabilities.h"

namespace analysis {
namespace {

bool isPositive(double number) {
  return number > 0.0 && std::isfinite(number);
}

void check(double f) {
  if (!(f >= 0.0) || !std::isfinite(f)) throw std::invalid_argument("F is finite and not negative");
}

/// P(F < f), to full precision where it is the smaller part; ratio = ν₁ f / ν₂.
double lowerP(double ratio, double degreesOfFreedom1, double degreesOfFreedom2) {
  const double y = ratio / (1.0 + ratio);
  return boost::math::ibeta(0.5 * degreesOfFreedom1, 0.5 * degreesOfFreedom2, y);
}

/// ln I_x(a, b) for an x so small that the series
///
///     I_x(a, b) = xᵃ (1 − x)ᵇ / (a B(a, b)) · Σ xⁿ (a + b)…(a + b + n − 1) / ((a + 1)…(a + n))
///
/// ends after some terms (Abramowitz & Stegun 26.5.4). logOdds = ln((1 − x) / x).
double logTail(double a, double b, double logOdds) {
  const double odds = std::exp(logOdds);
  const double x = 1.0 / (1.0 + odds);
  const double logX = std::isfinite(odds) ? -std::log1p(odds) : -logOdds;

  constexpr double kNegligible = 1e-17;
  double term = 1.0;
  double sum = 1.0;
  for (double n = 0.0; term > kNegligible * sum; ++n) {
    term *= x * (a + b + n) / (a + 1.0 + n);
    sum += term;
  }
  using boost::math::lgamma;
  const double logBeta = lgamma(a) + lgamma(b) - lgamma(a + b);
  return a * logX + b * std::log1p(-x) - std::log(a) - logBeta + std::log(sum);
}

}  // namespace

FisherDistribution::FisherDistribution(double degreesOfFreedom1, double degreesOfFreedom2)
    : degreesOfFreedom1_(degreesOfFreedom1), degreesOfFreedom2_(degreesOfFreedom2) {
  if (!isPositive(degreesOfFreedom1) || !isPositive(degreesOfFreedom2)) {
    throw std::invalid_argument("Fisher's F needs degrees of freedom above 0");
  }
}

double FisherDistribution::upperP(double f) const {
  check(f);
  const double ratio = degreesOfFreedom1_ / degreesOfFreedom2_ * f;
  const double a = 0.5 * degreesOfFreedom2_;
  const double b = 0.5 * degreesOfFreedom1_;
  // The argument of the smaller of x and 1 − x, so that neither is rounded to one.
  if (ratio < 1.0) return boost::math::ibetac(b, a, ratio / (1.0 + ratio));
  return boost::math::ibeta(a, b, 1.0 / (1.0 + ratio));
}

double FisherDistribution::log10UpperP(double f) const {
  constexpr double kHalf = 0.5;
  const double p = upperP(f);
  const double ratio = degreesOfFreedom1_ / degreesOfFreedom2_ * f;
  if (p > kHalf) {
    return std::log1p(-lowerP(ratio, degreesOfFreedom1_, degreesOfFreedom2_)) / std::numbers::ln10;
  }
  if (p > kSmallestExactP) return std::log10(p);
  const double logOdds = std::log(f) + std::log(degreesOfFreedom1_ / degreesOfFreedom2_);
  return logTail(kHalf * degreesOfFreedom2_, kHalf * degreesOfFreedom1_, logOdds) /
         std::numbers::ln10;
}

double FisherDistribution::upperQuantile(double p) const {
  if (!(p > 0.0 && p < 1.0)) throw std::invalid_argument("a probability lies between 0 and 1");
  using namespace boost::math::policies;
  using InfiniteBeyondADouble = policy<overflow_error<ignore_error>>;
  const boost::math::fisher_f_distribution<double, InfiniteBeyondADouble> distribution(
      degreesOfFreedom1_, degreesOfFreedom2_);
  return boost::math::quantile(boost::math::complement(distribution, p));
}

}  // namespace analysis
