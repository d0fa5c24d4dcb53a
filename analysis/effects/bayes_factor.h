#pragma once

#include <cstdint>
#include <optional>

#include "analysis/data/reason.h"
#include "analysis/hypothesis_tests/t_tests.h"

namespace analysis {

/// The "medium" scale of the Cauchy prior: √2 / 2.
inline constexpr double kMediumPriorScale = 0.70710678118654752440;

/// The Bayes factor BF₁₀: the probability of the data if there is a difference, divided by that if
/// there is none.
struct BayesFactor {
  double priorScale = kMediumPriorScale;
  std::optional<double> bf10;       ///< above 1: evidence for a difference; below 1: against it
  std::optional<double> log10Bf10;  ///< defined even if bf10 is beyond a double
  Reason reason;                    ///< why something above is missing; empty if nothing is
};

/// The JZS Bayes factor of a t test (Rouder et al. 2009), with a Cauchy prior of scale r on the
/// effect size:
///
///     BF₁₀ = ∫₀^∞ (1 + N g r²)^(−1/2) (1 + t² / ((1 + N g r²) ν))^(−(ν + 1)/2)
///                 (2π)^(−1/2) g^(−3/2) e^(−1/(2g)) dg  /  (1 + t²/ν)^(−(ν + 1)/2)
///
/// @param effectiveN  N: n of one sample or of pairs, n₁ n₂ / (n₁ + n₂) of two samples.
/// @throws std::invalid_argument  for a t that is not finite; for N, ν or r that is not finite and
///     above 0.
BayesFactor jzsBayesFactor(
    double t, double degreesOfFreedom, double effectiveN, double priorScale = kMediumPriorScale);

/// The Bayes factor of two samples, from Student's t. Only `reason` is set if t is not defined.
/// @throws std::invalid_argument  for a prior scale that is not finite and above 0.
BayesFactor jzsBayesFactor(
    const StudentResult& test,
    std::uint64_t n1,
    std::uint64_t n2,
    double priorScale = kMediumPriorScale);

/// The Bayes factor of pairs. Only `reason` is set if the test is not defined.
/// @throws std::invalid_argument  for a prior scale that is not finite and above 0.
BayesFactor jzsBayesFactor(const PairedTResult& test, double priorScale = kMediumPriorScale);

}  // namespace analysis
