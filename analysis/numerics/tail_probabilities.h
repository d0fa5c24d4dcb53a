#pragma once

namespace analysis {

/// Below this a probability is better taken from its logarithm: doubles lose digits soon after.
inline constexpr double kSmallestExactP = 1e-300;

// Tails of the laws that test statistics follow when groups are large. Each comes with its
// logarithm, which holds where the probability itself is too small for a double.

/// P(|Z| ≥ |z|) of the standard normal law.
double normalTwoSidedP(double z);
double log10NormalTwoSidedP(double z);

/// ln P(Z ≤ x) of the standard normal law, for any finite x.
double logNormalCdf(double x);

/// The z that |Z| stays below with a probability of @p level: 1.96 for 0.95.
/// @throws std::invalid_argument  for a level that is not between 0 and 1.
double normalTwoSidedQuantile(double level);

/// P(X ≥ x) of χ² with @p degreesOfFreedom, for x ≥ 0.
/// @throws std::invalid_argument  for a negative x or degrees of freedom that are not positive.
double chiSquaredP(double x, double degreesOfFreedom);
double log10ChiSquaredP(double x, double degreesOfFreedom);

}  // namespace analysis
