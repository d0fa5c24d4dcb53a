#pragma once

#include <span>
#include <vector>

#include "analysis/data/factor.h"
#include "analysis/data/reason.h"
#include "analysis/models/estimates.h"
#include "analysis/models/fixed_effects.h"

namespace analysis {

/// Least squares with standard errors that are valid for any correlation within a cluster.
struct ClusterRobustResult {
  std::vector<TEstimate> fixedEffects;  ///< one for each column; empty if the fit is not defined
  Reason reason;                        ///< why fixedEffects is empty; empty if the fit is defined
};

/// Fits y by ordinary least squares, with the bias-reduced covariance CR2 of the coefficients by
/// clusters, usually participants, and Satterthwaite's degrees of freedom, derived for independent
/// answers of equal variance (Bell & McCaffrey 2002, Survey Methodology 28, 169–181; Pustejovsky &
/// Tipton 2018, J. Bus. Econ. Stat. 36, 672–683):
///
///     (XᵀX)⁻¹ (Σ_g X_gᵀ A_g e_g e_gᵀ A_gᵀ X_g) (XᵀX)⁻¹,   A_g = (I − H_gg)^{−1/2}
///
/// with the pseudo-inverse root if I − H_gg is singular. With balanced data, t of the difference of
/// two methods equals t of the paired t-test on participants' means.
///
/// @throws std::invalid_argument  if y or @p cluster has another number of answers, or y a value
///     that is not finite.
ClusterRobustResult clusterRobust(
    std::span<const double> y, const FixedEffects& fixed, const Factor& cluster);

}  // namespace analysis
