#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/data/factor.h"
#include "analysis/numerics/arrow_matrix.h"
#include "analysis/numerics/newton_minimum.h"

namespace analysis {

/// −ln of the marginal likelihood of a cumulative link mixed model with logit link,
///
///     logit P(y_i ≤ c) = θ_c − (x_iᵀβ + Σ_k σ_k u_k[i]),   u ~ N(0, I),
///
/// by Laplace's approximation at the mode û of the joint density:
///
///     −ln L ≈ −Σ ln π_i(û) + ½ ûᵀû + ½ ln |D|,   D = I + Σ w_i z_i z_iᵀ,
///
/// with w_i the curvature of −ln π_i and z_i the σ_k at the places of answer i (Christensen, R
/// package ordinal; Pinheiro & Bates 1995, J. Comput. Graph. Stat. 4, 12–35). Without random
/// intercepts it is exact. The gradient is analytic, that of û included.
///
/// The parameters are θ_1 < … < θ_{K−1}, β, σ, in this order. The value is even in each σ.
class LaplaceLikelihood {
 public:
  /// @param y        from 0 to levels − 1.
  /// @param columns  those of x, one number per answer each.
  LaplaceLikelihood(
      std::vector<std::size_t> y,
      std::size_t levels,
      std::vector<std::vector<double>> columns,
      std::span<const Factor> random);

  std::size_t parameters() const noexcept;

  /// Nothing where the thresholds are not in order, or û is not found in 100 steps.
  std::optional<double> value(std::span<const double> parameters);
  std::optional<std::vector<double>> gradient(std::span<const double> parameters);
  /// With the Hessian by central differences of the gradient.
  std::optional<Derivatives> derivatives(std::span<const double> parameters);

 private:
  /// What depends on the parameters and u.
  struct Mode {
    std::vector<double> predictor;  ///< xᵀβ + zᵀu of each answer
    double penalised = 0.0;         ///< −Σ ln π + ½ uᵀu
    ArrowMatrix system;
  };

  std::vector<double> fixedPredictor(std::span<const double> parameters) const;
  double penalised(
      std::span<const double> parameters,
      const std::vector<double>& fixed,
      const std::vector<double>& u) const;
  double predictor(
      std::span<const double> sigma, const std::vector<double>& u, std::size_t i) const;
  double above(std::span<const double> parameters, std::size_t i) const;
  double below(std::span<const double> parameters, std::size_t i) const;
  bool isOrdered(std::span<const double> parameters) const;
  std::vector<double> newtonStep(
      std::span<const double> parameters, Mode& mode, const std::vector<double>& u) const;
  std::optional<Mode> findMode(std::span<const double> parameters);
  std::vector<double> curvatureSlope(
      std::span<const double> parameters, const Mode& mode, std::vector<double>& leverage) const;
  void addAnswer(
      std::size_t i,
      std::span<const double> parameters,
      const Mode& mode,
      double leverage,
      const std::vector<double>& slope,
      std::vector<double>& gradient) const;

  std::vector<std::size_t> y_;
  std::size_t thresholds_;
  std::vector<std::vector<double>> columns_;
  std::size_t intercepts_;
  std::vector<std::size_t> places_;  ///< of each answer's random effects, intercept by intercept
  std::size_t largest_ = 0;          ///< levels of the intercept with most of them
  std::size_t effects_ = 0;
  std::vector<double> u_;  ///< the last mode, from which the next is sought
};

}  // namespace analysis
