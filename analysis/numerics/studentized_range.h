#pragma once

#include <cstddef>

namespace analysis {

/// The range of k independent standard normal values: Tukey's studentized range with infinitely
/// many degrees of freedom, as Nemenyi's comparisons need it.
///
///     P(Q ≥ q) = k ∫ φ(z) [Φ(z)^(k−1) − (Φ(z) − Φ(z − q))^(k−1)] dz
///
/// The trapezoidal rule is as exact as a double on this integrand, whose terms are all positive:
/// some 13 digits of p, and log10P also where p is too small for a double.
///
/// @param q  0 … 100 000
/// @param k  2 … 10 000
/// @throws std::invalid_argument  for others.
double studentizedRangeP(double q, std::size_t k);
double log10StudentizedRangeP(double q, std::size_t k);

}  // namespace analysis
