#include "analysis/numerics/distributions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/fraction.hpp>
#include <boost/math/tools/roots.hpp>

#include "analysis/numerics/tail_probabilities.h"

namespace analysis {
namespace {

constexpr double kLargeT = 1e100;  // its square is still a double
constexpr double kSmallT = 0.6;    // P(|T| < 0.6) is below one half for every ν ≥ 1

/// The continued fraction of I_x(a, 1/2) after Didonato & Morris 1992, written with y = 1 − x, so
/// that nothing cancels where x is nearly one.
class TailFraction {
 public:
  using result_type = std::pair<double, double>;  // name required by Boost

  TailFraction(double a, double y) : a_(a), y_(y) {}

  result_type operator()() {
    constexpr double kB = 0.5;
    const double m = m_++;
    const double x = 1.0 - y_;
    const double gap = 1.0 - kB + (a_ + kB) * y_ + m * (1.0 + y_);
    const double under = (a_ + m) * gap / (a_ + 2.0 * m + 1.0);
    if (m == 0.0) return {0.0, under};

    const double step = m * (kB - m) * x / (a_ + 2.0 * m - 1.0);
    const double over = step * (a_ + m - 1.0) * (a_ + kB + m - 1.0) * x / (a_ + 2.0 * m - 1.0);
    return {over, m + step + under};
  }

 private:
  double a_;
  double y_;
  double m_ = 0.0;
};

/// ln I_x(ν/2, 1/2), x = ν / (ν + t²), for a large t.
double logTail(double t, double degreesOfFreedom) {
  const double a = 0.5 * degreesOfFreedom;
  const double root = t / std::sqrt(degreesOfFreedom);
  const double logX = root < kLargeT ? -std::log1p(root * root) : -2.0 * std::log(root);
  const double rootOfY = root / std::hypot(1.0, root);

  TailFraction fraction(a, rootOfY * rootOfY);
  std::uintmax_t terms = 1000;  // upper limit; about ten are used
  const double under = boost::math::tools::continued_fraction_b(fraction, 1e-15, terms);
  const double beta = std::sqrt(std::numbers::pi) * boost::math::tgamma_delta_ratio(a, 0.5);
  return a * logX + std::log(rootOfY) - std::log(beta) - std::log(under);
}

/// P(|T| < |t|), to full precision where it is below one half.
double centralProbability(double t, double degreesOfFreedom) {
  return boost::math::ibeta(0.5, 0.5 * degreesOfFreedom, t * t / (degreesOfFreedom + t * t));
}

void check(double t, double degreesOfFreedom, double noncentrality) {
  if (!(degreesOfFreedom >= 1.0) || !std::isfinite(degreesOfFreedom)) {
    throw std::invalid_argument("the noncentral t needs at least one degree of freedom");
  }
  if (!std::isfinite(t) || !std::isfinite(noncentrality)) {
    throw std::invalid_argument("the noncentral t needs a finite t and noncentrality");
  }
}

/// P(T ≤ t) for large t and δ.
double probabilityFarOut(double t, double degreesOfFreedom, double noncentrality) {
  constexpr double kNormalReach = 9.0;  // Φ(−9) = 1e-19
  const double half = 0.5 * degreesOfFreedom;
  // |S − 1| is larger with a probability below e^−45.
  const double spread = 10.5 / std::sqrt(degreesOfFreedom);

  // y = t s − δ
  const double low = std::max(-kNormalReach, t * std::max(0.0, 1.0 - spread) - noncentrality);
  const double high = std::min(kNormalReach, t * (1.0 + spread) - noncentrality);
  const auto squareOfS = [&](double y) {
    const double s = (y + noncentrality) / t;
    return half * s * s;
  };
  if (low >= kNormalReach) return 1.0;
  if (high <= -kNormalReach) return 0.0;

  const auto integrand = [&](double y) {
    const double x = squareOfS(y);
    const double density = boost::math::gamma_p_derivative(half, x) * 2.0 * x / (y + noncentrality);
    return density * normalUpperP(-y);
  };
  constexpr unsigned kDepth = 6;
  // Absolute error of the probability: a few units in the last place.
  constexpr double kTolerance = 1e-14;
  using Rule = boost::math::quadrature::gauss_kronrod<double, 61>;
  const double above = boost::math::gamma_q(half, squareOfS(high));
  return std::min(1.0, above + Rule::integrate(integrand, low, high, kDepth, kTolerance));
}

/// The δ with P(T ≤ t | δ) = @p tail, for a tail of less than one half. The probability falls as δ
/// rises.
double upperLimit(double t, double degreesOfFreedom, double tail) {
  const auto excess = [&](double noncentrality) {
    return noncentralTProbability(t, degreesOfFreedom, noncentrality) - tail;
  };
  // Brackets the root by steps of doubling length; then the solver narrows the bracket.
  double low = t;
  for (double reach = 1.0; excess(low) < 0.0; reach *= 2.0) low -= reach;
  double high = low + 1.0;
  for (double reach = 2.0; excess(high) > 0.0; reach *= 2.0) {
    low = high;
    high += reach;
  }

  std::uintmax_t steps = 200;  // upper limit; about ten are used
  const boost::math::tools::eps_tolerance<double> allDigits(52);
  const auto bracket = boost::math::tools::toms748_solve(excess, low, high, allDigits, steps);
  return 0.5 * (bracket.first + bracket.second);
}

}  // namespace

StudentDistribution::StudentDistribution(double degreesOfFreedom)
    : degreesOfFreedom_(degreesOfFreedom) {
  if (!(degreesOfFreedom >= 1.0) || !std::isfinite(degreesOfFreedom)) {
    throw std::invalid_argument("Student's t needs at least one degree of freedom");
  }
}

double StudentDistribution::twoSidedP(double t) const {
  if (std::abs(t) >= kLargeT) return std::exp(logTail(std::abs(t), degreesOfFreedom_));
  // Near zero the central probability is the smaller one, and keeps digits that Boost's tail loses.
  if (std::abs(t) < kSmallT) return 1.0 - centralProbability(t, degreesOfFreedom_);
  const boost::math::students_t distribution(degreesOfFreedom_);
  return 2.0 * boost::math::cdf(boost::math::complement(distribution, std::abs(t)));
}

double StudentDistribution::log10TwoSidedP(double t) const {
  const double p = twoSidedP(t);
  if (std::abs(t) < kSmallT)
    return std::log1p(-centralProbability(t, degreesOfFreedom_)) / std::numbers::ln10;
  if (p > kSmallestExactP) return std::log10(p);
  return logTail(std::abs(t), degreesOfFreedom_) / std::numbers::ln10;
}

double StudentDistribution::twoSidedQuantile(double p) const {
  if (!(p > 0.0 && p <= 1.0)) throw std::invalid_argument("a probability lies between 0 and 1");
  const boost::math::students_t distribution(degreesOfFreedom_);
  return boost::math::quantile(boost::math::complement(distribution, 0.5 * p));
}

std::optional<Interval> studentInterval(
    const std::optional<double>& estimate,
    const std::optional<double>& standardError,
    const std::optional<double>& degreesOfFreedom,
    double level) {
  requireConfidenceLevel(level);
  if (!estimate || !standardError || !degreesOfFreedom) return std::nullopt;
  const StudentDistribution law(*degreesOfFreedom);
  const double reach = law.twoSidedQuantile(1.0 - level) * *standardError;
  if (!std::isfinite(std::abs(*estimate) + reach)) return std::nullopt;
  return Interval{.low = *estimate - reach, .high = *estimate + reach};
}

double noncentralTProbability(double t, double degreesOfFreedom, double noncentrality) {
  check(t, degreesOfFreedom, noncentrality);
  constexpr double kLargestNoncentrality = 100.0;
  if (noncentrality < -kLargestNoncentrality) {
    return 1.0 - noncentralTProbability(-t, degreesOfFreedom, -noncentrality);
  }
  if (noncentrality > kLargestNoncentrality) {
    return t > 0.0 ? probabilityFarOut(t, degreesOfFreedom, noncentrality) : 0.0;
  }
  const boost::math::non_central_t law(degreesOfFreedom, noncentrality);
  return boost::math::cdf(law, t);
}

Interval noncentralityInterval(double t, double degreesOfFreedom, double level) {
  check(t, degreesOfFreedom, 0.0);
  requireConfidenceLevel(level);
  const double tail = 0.5 * (1.0 - level);
  return {
      .low = -upperLimit(-t, degreesOfFreedom, tail),
      .high = upperLimit(t, degreesOfFreedom, tail)};
}

namespace {

bool isPositive(double number) {
  return number > 0.0 && std::isfinite(number);
}

void check(double f) {
  if (!(f >= 0.0) || !std::isfinite(f)) throw std::invalid_argument("F is finite and not negative");
}

/// P(F < f), to full precision where it is below one half; ratio = ν₁ f / ν₂.
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

  // Relative to the sum: less than half a unit in its last place.
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
  // Passes the smaller one of x and 1 − x, because the larger one may be rounded to one.
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
  using OverflowToInfinity = policy<overflow_error<ignore_error>>;
  const boost::math::fisher_f_distribution<double, OverflowToInfinity> distribution(
      degreesOfFreedom1_, degreesOfFreedom2_);
  return boost::math::quantile(boost::math::complement(distribution, p));
}

}  // namespace analysis
