#include "analysis/numerics/student_distribution.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/fraction.hpp>

#include "analysis/numerics/tail_probabilities.h"

namespace analysis {
namespace {

constexpr double kLargeT = 1e100;  // its square is still a double
constexpr double kSmallT = 0.6;    // the centre holds less than half of any Student's law

/// The continued fraction of I_x(a, 1/2) after Didonato & Morris 1992, written with y = 1 − x, so
/// that nothing cancels where x is nearly one.
class TailFraction {
 public:
  using result_type = std::pair<double, double>;  // NOLINT: what Boost looks for

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

/// ln I_x(ν/2, 1/2), x = ν / (ν + t²), for a t far out.
double logTail(double t, double degreesOfFreedom) {
  const double a = 0.5 * degreesOfFreedom;
  const double root = t / std::sqrt(degreesOfFreedom);
  const double logX = root < kLargeT ? -std::log1p(root * root) : -2.0 * std::log(root);
  const double rootOfY = root / std::hypot(1.0, root);

  TailFraction fraction(a, rootOfY * rootOfY);
  std::uintmax_t terms = 1000;  // some ten are enough
  const double under = boost::math::tools::continued_fraction_b(fraction, 1e-15, terms);
  const double beta = std::sqrt(std::numbers::pi) * boost::math::tgamma_delta_ratio(a, 0.5);
  return a * logX + std::log(rootOfY) - std::log(beta) - std::log(under);
}

/// P(|T| < |t|), to full precision where it is the smaller part.
double centre(double t, double degreesOfFreedom) {
  return boost::math::ibeta(0.5, 0.5 * degreesOfFreedom, t * t / (degreesOfFreedom + t * t));
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
  if (std::abs(t) < kSmallT) return 1.0 - centre(t, degreesOfFreedom_);  // Boost loses digits there
  const boost::math::students_t distribution(degreesOfFreedom_);
  return 2.0 * boost::math::cdf(boost::math::complement(distribution, std::abs(t)));
}

double StudentDistribution::log10TwoSidedP(double t) const {
  const double p = twoSidedP(t);
  if (std::abs(t) < kSmallT) return std::log1p(-centre(t, degreesOfFreedom_)) / std::numbers::ln10;
  if (p > kSmallestExactP) return std::log10(p);
  return logTail(std::abs(t), degreesOfFreedom_) / std::numbers::ln10;
}

double StudentDistribution::twoSidedQuantile(double p) const {
  if (!(p > 0.0 && p <= 1.0)) throw std::invalid_argument("a probability lies between 0 and 1");
  const boost::math::students_t distribution(degreesOfFreedom_);
  return boost::math::quantile(boost::math::complement(distribution, 0.5 * p));
}

}  // namespace analysis
