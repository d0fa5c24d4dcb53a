#pragma once

#include <optional>
#include <span>

#include "analysis/data/moments.h"

namespace analysis {

/// What Student's t-test says about two groups; all are missing where it is not defined.
struct StudentResult {
  std::optional<double> t;                 ///< ±infinity for two constant groups that differ
  std::optional<double> degreesOfFreedom;  ///< n₁ + n₂ − 2
  std::optional<double> p;                 ///< two-sided
};

/// Student's t-test: Welch's elder, which trusts that both groups have the same variance.
///
///     t = (m₁ − m₂) / √(s² (1/n₁ + 1/n₂)),   s² = ((n₁ − 1) s₁² + (n₂ − 1) s₂²) / (n₁ + n₂ − 2)
///
/// For comparison with published results; welchTTest() needs less trust.
///
/// @throws std::invalid_argument  if a value is infinite or NaN.
StudentResult studentTTest(std::span<const double> group1, std::span<const double> group2);
StudentResult studentTTest(const Moments& group1, const Moments& group2);

}  // namespace analysis
