#pragma once

namespace analysis {

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

/// P(X ≥ f) of the F law with @p df1 and @p df2 degrees of freedom, for f ≥ 0.
/// @throws std::invalid_argument  for a negative f or degrees of freedom that are not positive.
double fP(double f, double df1, double df2);
double log10FP(double f, double df1, double df2);

}  // namespace analysis
