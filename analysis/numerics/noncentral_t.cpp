#include "analysis/numerics/noncentral_t.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>

#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/roots.hpp>

namespace analysis {
namespace {

void check(double t, double degreesOfFreedom, double noncentrality) {
  if (!(degreesOfFreedom >= 1.0) || !std::isfinite(degreesOfFreedom)) {
    throw std::invalid_argument("the noncentral t needs at least one degree of freedom");
  }
  if (!std::isfinite(t) || !std::isfinite(noncentrality)) {
    throw std::invalid_argument("the noncentral t needs a finite t and noncentrality");
  }
}

/// P(T ≤ t) for t and δ far above 0.
double probabilityFarOut(double t, double degreesOfFreedom, double noncentrality) {
  constexpr double kNormalReach = 9.0;  // Φ(−9) = 1e-19
  const double half = 0.5 * degreesOfFreedom;
  const double spread = 10.5 / std::sqrt(degreesOfFreedom);  // beyond it, S has less than e^−45

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
    return density * 0.5 * std::erfc(-y / std::numbers::sqrt2);
  };
  constexpr unsigned kDepth = 6;
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
  double low = t;
  for (double reach = 1.0; excess(low) < 0.0; reach *= 2.0) low -= reach;
  double high = low + 1.0;
  for (double reach = 2.0; excess(high) > 0.0; reach *= 2.0) {
    low = high;
    high += reach;
  }

  std::uintmax_t steps = 200;  // some ten are enough
  const boost::math::tools::eps_tolerance<double> allDigits(52);
  const auto bracket = boost::math::tools::toms748_solve(excess, low, high, allDigits, steps);
  return 0.5 * (bracket.first + bracket.second);
}

}  // namespace

double noncentralTProbability(double t, double degreesOfFreedom, double noncentrality) {
  check(t, degreesOfFreedom, noncentrality);
  constexpr double kFarOut = 100.0;
  if (noncentrality < -kFarOut) {
    return 1.0 - noncentralTProbability(-t, degreesOfFreedom, -noncentrality);
  }
  if (noncentrality > kFarOut) {
    return t > 0.0 ? probabilityFarOut(t, degreesOfFreedom, noncentrality) : 0.0;
  }
  const boost::math::non_central_t law(degreesOfFreedom, noncentrality);
  return boost::math::cdf(law, t);
}

Interval noncentralityInterval(double t, double degreesOfFreedom, double level) {
  check(t, degreesOfFreedom, 0.0);
  if (!(level > 0.0 && level < 1.0)) {
    throw std::invalid_argument("a confidence level lies between 0 and 1");
  }
  const double tail = 0.5 * (1.0 - level);
  return {
      .low = -upperLimit(-t, degreesOfFreedom, tail),
      .high = upperLimit(t, degreesOfFreedom, tail)};
}

}  // namespace analysis
