#pragma once

#include <span>
#include <vector>

namespace analysis {

/// The loadings of several items on one common factor.
struct OneFactorModel {
  std::vector<double> loadings;  ///< of the standardised items, −1 … 1; their sum is not negative
  bool isImproper = false;  ///< a loading is ±1 (Heywood case): an item without an error of its own
  bool hasConverged = true;  ///< false where the loadings still moved after all steps
};

/// The least-squares loadings λ of the correlations r of the items (minres, Harman & Jones 1966):
///
///     minimise Σ over i < j of (rᵢⱼ − λᵢ λⱼ)²,  with |λᵢ| ≤ 1 (Harman & Fukuda 1966)
///
/// Each loading in turn takes its best value, λᵢ = Σ rᵢⱼ λⱼ / Σ λⱼ² over j ≠ i, until none moves,
/// beginning with the first principal component. Works also for few respondents, where the
/// correlations have no inverse and maximum likelihood has no answer.
///
/// @param correlations  a symmetric matrix with ones on its diagonal.
/// @throws std::invalid_argument  for fewer than three items, which do not determine the loadings;
///     for a matrix that is not square or has entries outside −1 … 1.
OneFactorModel fitOneFactor(std::span<const std::vector<double>> correlations);

}  // namespace analysis
