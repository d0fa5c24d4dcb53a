#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "analysis/data/factor.h"
#include "analysis/models/fixed_effects.h"
#include "analysis/numerics/newton_minimum.h"

namespace analysis {

/// What a linear mixed model is at given variances. Matrices are row by row.
struct RestrictedSolution {
  double deviance = 0.0;             ///< −2 × the restricted log likelihood
  double residualVariance = 0.0;     ///< σ²
  std::vector<double> coefficients;  ///< p
  std::vector<double> covariance;    ///< of the coefficients, p × p
  /// ∂covariance / ∂variance for the variance of each random intercept, then of the residuals.
  std::vector<std::vector<double>> covarianceDerivatives;
  /// Second derivatives of the deviance in the same variances.
  std::vector<double> hessian;
};

/// The restricted deviance of y = X β + Σ Z_k b_k + e with b_k ~ N(0, φ_k σ² I), e ~ N(0, σ² I),
/// β and σ² profiled out, as a function of the relative variances φ_k (Bates, Mächler, Bolker &
/// Walker 2015, Fitting linear mixed-effects models using lme4, eq. (39) to (42)):
///
///     d(φ) = ln |V| + ln |XᵀV⁻¹X| + (n − p) (1 + ln(2π r² / (n − p))),
///     V = I + Σ φ_k Z_k Z_kᵀ,   P = V⁻¹ − V⁻¹X (XᵀV⁻¹X)⁻¹ XᵀV⁻¹,   r² = yᵀPy,   σ² = r² / (n − p)
///
///     ∂d/∂φ_k = tr(Z_kᵀPZ_k) − |Z_kᵀPy|² / σ²
///
/// Only ZᵀZ, ZᵀX and Zᵀy are kept, with X made orthonormal and y without its projection on X, so
/// that neither the scale of a covariate nor an offset of y costs digits.
class RestrictedDeviance {
 public:
  /// @param fixed  of full rank, with fewer columns than answers.
  RestrictedDeviance(
      std::span<const double> y, const FixedEffects& fixed, std::span<const Factor> random);
  ~RestrictedDeviance();
  RestrictedDeviance(const RestrictedDeviance&) = delete;
  RestrictedDeviance& operator=(const RestrictedDeviance&) = delete;

  /// Whether y lies in the space of the fixed effects, but for rounding.
  bool isExplainedByFixedEffects() const;
  /// Whether the fixed effects leave nothing of a random intercept, as those of participants would
  /// of the participants'.
  bool isExplainedByFixedEffects(std::size_t intercept) const;

  /// Nothing where no residual variance is left.
  std::optional<double> value(std::span<const double> relativeVariances) const;
  std::optional<Derivatives> derivatives(std::span<const double> relativeVariances) const;
  std::optional<RestrictedSolution> solution(std::span<const double> relativeVariances) const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

}  // namespace analysis
