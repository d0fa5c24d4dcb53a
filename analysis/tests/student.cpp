#include "analysis/tests/student.h"

#include <cmath>

#include "analysis/data/moments.h"
#include "analysis/numerics/student_distribution.h"

namespace analysis {

StudentResult studentTTest(std::span<const double> group1, std::span<const double> group2) {
  return studentTTest(momentsOf(group1), momentsOf(group2));
}

StudentResult studentTTest(const Moments& group1, const Moments& group2) {
  StudentResult result;
  if (group1.n == 0 || group2.n == 0 || group1.n + group2.n < 3) return result;

  const auto n1 = static_cast<double>(group1.n);
  const auto n2 = static_cast<double>(group2.n);
  const Contrast contrast = contrastOf(group1, group2);
  const DoubleDouble squares = contrast.variance1 * (n1 - 1.0) + contrast.variance2 * (n2 - 1.0);
  const DoubleDouble pooled = squares / (n1 + n2 - 2.0);
  const double t = tOf(contrast, squareRoot(pooled * (DoubleDouble(n1) + n2) / n1 / n2));
  if (pooled.isZero() && t == 0.0) return result;

  result.t = t;
  if (pooled.isZero()) return result;

  result.degreesOfFreedom = n1 + n2 - 2.0;
  if (std::isfinite(t)) result.p = StudentDistribution(*result.degreesOfFreedom).twoSidedP(t);
  return result;
}

}  // namespace analysis
