#pragma once

#include <cstddef>

namespace analysis {

/// @throws std::invalid_argument  for a level of confidence that is not between 0 and 1.
void requireConfidenceLevel(double level);

/// Probabilities below this are computed from their logarithm, because a double loses digits below
/// 2.2e-308.
inline constexpr double kSmallestExactP = 1e-300;

// Tail probabilities of the asymptotic distributions of test statistics. The log10 functions are
// accurate also where the probability is too small for a double.

/// P(|Z| ≥ |z|) of the standard normal distribution.
double normalTwoSidedP(double z);
double log10NormalTwoSidedP(double z);

/// P(Z ≥ z) of the standard normal distribution.
double normalUpperP(double z);

/// ln P(Z ≤ x) of the standard normal distribution, for any finite x; to about 14 digits.
double logNormalCdf(double x);

/// The z with P(|Z| < z) = @p level: 1.96 for 0.95.
/// @throws std::invalid_argument  for a level that is not between 0 and 1.
double normalTwoSidedQuantile(double level);

/// P(X ≥ x) of χ² with @p degreesOfFreedom, for x ≥ 0.
/// @throws std::invalid_argument  for a negative x or degrees of freedom that are not positive.
double chiSquaredP(double x, double degreesOfFreedom);
double log10ChiSquaredP(double x, double degreesOfFreedom);

/// The x with P(X ≥ x) = @p p for X of χ²; p in (0, 1).
double chiSquaredUpperQuantile(double p, double degreesOfFreedom);

/// The tail probability of the range of k independent standard normal values, that is Tukey's
/// studentized range with infinitely many degrees of freedom, for Nemenyi's comparisons.
///
///     P(Q ≥ q) = k ∫ φ(z) [Φ(z)^(k−1) − (Φ(z) − Φ(z − q))^(k−1)] dz
///
/// Computed by the trapezoidal rule with steps of 1/32, which converges exponentially for an
/// analytic integrand that vanishes at both ends. All terms are positive, so that nothing cancels:
/// p has about 13 digits, and its logarithm is accurate also where p is too small for a double.
///
/// @param q  0 … 100 000
/// @param k  2 … 10 000
/// @throws std::invalid_argument  for another q or k.
double studentizedRangeP(double q, std::size_t k);
double log10StudentizedRangeP(double q, std::size_t k);

}  // namespace analysis
