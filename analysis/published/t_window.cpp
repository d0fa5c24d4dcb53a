#include "analysis/published/t_window.h"

#include <cmath>
#include <limits>

#include "analysis/numerics/student_distribution.h"

namespace analysis {

TWindow::TWindow(const Interval& p, const PublishedConvention& convention)
    : p_(p), convention_(convention), limits_(1) {}

const TWindow::Limits& TWindow::limitsAt(std::size_t degreesOfFreedom) const {
  const double tails = convention_.tails == PublishedConvention::Tails::Two ? 1.0 : 2.0;
  while (limits_.size() <= degreesOfFreedom) {
    const StudentDistribution law(static_cast<double>(limits_.size()));
    const auto limit = [&](double p) {
      if (p <= 0.0) return std::numeric_limits<double>::infinity();
      return p >= 1.0 ? 0.0 : law.twoSidedQuantile(p);
    };
    limits_.push_back({.nearest = limit(tails * p_.high), .furthest = limit(tails * p_.low)});
  }
  return limits_[degreesOfFreedom];
}

bool TWindow::holds(const LatticePoint& group1, const LatticePoint& group2) const {
  constexpr double kMargin = 1e-9;  // of t: what lies nearer to a limit is decided by its p
  const auto spread =
      spreadOfDifference(convention_.test, group1.variance, group1.n, group2.variance, group2.n);
  const double difference = std::abs(group1.mean - group2.mean);
  if (spread.standardError > 0.0) {
    const double t = difference / spread.standardError;
    // For a given p, t falls with the degrees of freedom.
    const auto below = static_cast<std::size_t>(spread.degreesOfFreedom);
    const Limits wide = limitsAt(below);
    const Limits narrow = limitsAt(below + 1);
    if (t > wide.nearest + kMargin && t < narrow.furthest - kMargin) return true;
    if (t < narrow.nearest - kMargin || t > wide.furthest + kMargin) return false;
  }
  const double p = pOf(difference, spread, convention_.tails);
  return p_.low - 1e-12 <= p && p <= p_.high + 1e-12;
}

}  // namespace analysis
