#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "analysis/data/factor.h"
#include "analysis/models/fixed_effects.h"
#include "analysis/numerics/newton_minimum.h"

namespace analysis {

/// The solution of a linear mixed model with p fixed effects at given relative variances.
struct RestrictedSolution {
  double deviance = 0.0;          ///< −2 × the restricted log likelihood
  double residualVariance = 0.0;  ///< σ²
  Eigen::VectorXd coefficients;   ///< p fixed effects
  Eigen::MatrixXd covariance;     ///< of the coefficients, p × p
  /// ∂covariance / ∂variance for the variance of each random intercept, then of the residuals.
  std::vector<Eigen::MatrixXd> covarianceDerivatives;
  /// Second derivatives of the deviance with respect to the variances in covarianceDerivatives.
  Eigen::MatrixXd hessian;
};

/// The restricted deviance of y = X β + Σ Z_k b_k + e with b_k ~ N(0, φ_k σ² I), e ~ N(0, σ² I),
/// β and σ² profiled out, as a function of the relative variances φ_k ≥ 0 (Bates, Mächler, Bolker &
/// Walker 2015, Fitting linear mixed-effects models using lme4, eq. (39) to (42)):
///
///     d(φ) = ln |V| + ln |XᵀV⁻¹X| + (n − p) (1 + ln(2π r² / (n − p))),
///     V = I + Σ φ_k Z_k Z_kᵀ,   P = V⁻¹ − V⁻¹X (XᵀV⁻¹X)⁻¹ XᵀV⁻¹,   r² = yᵀPy,   σ² = r² / (n − p)
///
///     ∂d/∂φ_k = tr(Z_kᵀPZ_k) − |Z_kᵀPy|² / σ²
///
/// Stores only ZᵀZ, ZᵀX and Zᵀy, with X orthonormalised and y minus its projection on X, so that
/// neither the scale of a covariate nor an offset of y costs accuracy.
class RestrictedDeviance {
 public:
  /// @param y      must be finite.
  /// @param fixed  must have full rank and fewer columns than answers.
  RestrictedDeviance(
      std::span<const double> y, const FixedEffects& fixed, std::span<const Factor> random);

  /// Whether y is, up to rounding, a linear combination of the fixed effects.
  bool isExplainedByFixedEffects() const;
  /// Whether the fixed effects explain the levels of a random intercept completely, as participant
  /// as a fixed effect would explain participant as a random intercept.
  bool isExplainedByFixedEffects(std::size_t intercept) const;

  /// std::nullopt if no residual variance is left.
  std::optional<double> value(const Eigen::VectorXd& relativeVariances) const;
  std::optional<Derivatives> derivatives(const Eigen::VectorXd& relativeVariances) const;
  std::optional<RestrictedSolution> solution(const Eigen::VectorXd& relativeVariances) const;

 private:
  struct Profile;
  struct Projection;
  struct QuadraticForms;

  void addFixed(std::span<const double> y, const FixedEffects& fixed, Eigen::MatrixXd& x);
  void addRandom(std::span<const Factor> random, const Eigen::MatrixXd& x);
  std::optional<Profile> profileAt(const Eigen::VectorXd& relativeVariances) const;
  Projection projectionOf(const Profile& profile) const;
  QuadraticForms formsOf(const Projection& projection) const;
  Eigen::MatrixXd varianceHessian(
      const Projection& projection, double variance, const Eigen::VectorXd& relative) const;
  double degreesOfFreedom() const { return static_cast<double>(answers_ - columns_); }

  Eigen::Index answers_;
  Eigen::Index columns_;
  std::vector<Eigen::Index> levels_;  ///< number of levels of each random intercept
  /// For each random intercept, the index of its first random effect.
  std::vector<Eigen::Index> firstEffect_;
  double offset_ = 0.0;                ///< y of the first answer, subtracted from all
  double sumOfSquares_ = 0.0;          ///< of y around its mean
  double residualSumOfSquares_ = 0.0;  ///< sum of squares of residuals_
  Eigen::VectorXd residuals_;          ///< y without the fixed effects
  Eigen::MatrixXd triangularFactor_;   ///< R of X = QR, with Q orthonormal
  Eigen::VectorXd coefficients_;       ///< least-squares coefficients of the orthonormalised X
  Eigen::MatrixXd ztz_;
  Eigen::MatrixXd ztx_;
  Eigen::VectorXd zty_;
};

}  // namespace analysis
