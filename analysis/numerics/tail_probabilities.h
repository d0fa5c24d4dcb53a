#pragma once

#include <cstddef>

namespace analysis {

/// Below this a probability is better taken from its logarithm: below 2.2e-308 a double loses
/// digits.
inline constexpr double kSmallestExactP = 1e-300;

// Tails of the distributions that test statistics have when groups are large. Each comes with its
// logarithm, which is right also where the probability itself is too small for a double.

/// P(|Z| ≥ |z|) of the standard normal law.
double normalTwoSidedP(double z);
double log10NormalTwoSidedP(double z);

/// P(Z ≥ z) of the standard normal law.
double normalUpperP(double z);

/// ln P(Z ≤ x) of the standard normal law, for any finite x; to about 14 digits.
double logNormalCdf(double x);

/// The z that |Z| stays below with a probability of @p level: 1.96 for 0.95.
/// @throws std::invalid_argument  for a level that is not between 0 and 1.
double normalTwoSidedQuantile(double level);

/// P(X ≥ x) of χ² with @p degreesOfFreedom, for x ≥ 0.
/// @throws std::invalid_argument  for a negative x or degrees of freedom that are not positive.
double chiSquaredP(double x, double degreesOfFreedom);
double log10ChiSquaredP(double x, double degreesOfFreedom);

/// The x that χ² exceeds with a probability of @p p in (0, 1).
double chiSquaredUpperQuantile(double p, double degreesOfFreedom);

/// The range of k independent standard normal values: Tukey's studentized range with infinitely
/// many degrees of freedom, as Nemenyi's comparisons need it.
///
///     P(Q ≥ q) = k ∫ φ(z) [Φ(z)^(k−1) − (Φ(z) − Φ(z − q))^(k−1)] dz
///
/// By the trapezoidal rule with steps of 1/32, which converges exponentially for an analytic
/// integrand that vanishes at both ends. All terms are positive, so that nothing cancels: some 13
/// digits of p, and log10P also where p is too small for a double.
///
/// @param q  0 … 100 000
/// @param k  2 … 10 000
/// @throws std::invalid_argument  for others.
double studentizedRangeP(double q, std::size_t k);
double log10StudentizedRangeP(double q, std::size_t k);

}  // namespace analysis
