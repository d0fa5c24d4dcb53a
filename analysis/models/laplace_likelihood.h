#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/SparseCholesky>

#include "analysis/data/factor.h"
#include "analysis/numerics/newton_minimum.h"

namespace analysis {

/// F(x) = 1 / (1 + e^−x), to full precision also for a very negative x.
double logistic(double x);

/// The log probability ln π of one answer in a cumulative logit model, and its derivatives.
///
/// With η the linear predictor, a = θ_y − η above and b = θ_{y−1} − η below the answer,
///
///     π = F(a) − F(b) = F(a) (1 − F(b)) (1 − e^{b−a}),   F(x) = 1 / (1 + e^{−x}),
///
/// where the last factor does not depend on η. This form has no cancellation even for a very small
/// π.
struct CumulativeLogit {
  /// @param above  a, +infinity for the highest level.
  /// @param below  b < a, −infinity for the lowest level.
  CumulativeLogit(double above, double below);

  double logProbability;
  double slope;              ///< d ln π / dη
  double weight;             ///< −d² ln π / dη² = f(a) + f(b) > 0, with f = F (1 − F)
  double slopeAbove;         ///< d ln π / da
  double slopeBelow;         ///< d ln π / db
  double densityAbove;       ///< f(a) = d² ln π / (da dη)
  double densityBelow;       ///< f(b) = d² ln π / (db dη)
  double densitySlopeAbove;  ///< f'(a); d weight / dη = −f'(a) − f'(b)
  double densitySlopeBelow;  ///< f'(b)
};

/// −ln of the marginal likelihood of a cumulative link mixed model with logit link,
///
///     logit P(y_i ≤ c) = θ_c − (x_iᵀβ + Σ_k σ_k u_k[i]),   u ~ N(0, I),
///
/// by Laplace's approximation at the mode û of the joint density:
///
///     −ln L ≈ −Σ ln π_i(û) + ½ ûᵀû + ½ ln |D|,   D = I + Σ w_i z_i z_iᵀ,
///
/// with w_i the curvature of −ln π_i, and z_i the vector that holds σ_k at the level of intercept k
/// that answer i has (Christensen, R package ordinal; Pinheiro & Bates 1995, J. Comput. Graph.
/// Stat. 4, 12–35). Without random intercepts the value is exact. The gradient is analytic and
/// includes the change of û. D and its Cholesky factor are sparse.
///
/// The parameters are θ_1 < … < θ_{K−1}, β, σ, in this order. The value is even in each σ.
class LaplaceLikelihood {
 public:
  /// @param y       from 0 to levels − 1.
  /// @param x       one row per answer, one column per effect, without an intercept.
  LaplaceLikelihood(
      std::vector<std::size_t> y,
      std::size_t levels,
      Eigen::MatrixXd x,
      std::span<const Factor> random);

  Eigen::Index parameters() const noexcept;

  /// std::nullopt if the thresholds do not increase, or û is not found in 100 steps.
  std::optional<double> value(const Eigen::VectorXd& parameters);
  std::optional<Eigen::VectorXd> gradient(const Eigen::VectorXd& parameters);
  /// The gradient, and the Hessian computed by central differences of the gradient.
  std::optional<Derivatives> derivatives(const Eigen::VectorXd& parameters);

 private:
  using Sparse = Eigen::SparseMatrix<double>;

  /// The answers at given parameters and the random effects û.
  struct Mode {
    Sparse z;  ///< z_i in column i
    Eigen::VectorXd u;
    std::vector<CumulativeLogit> answers;
    double penalisedNegativeLog = 0.0;  ///< −Σ ln π + ½ uᵀu
  };

  Sparse effectsOfAnswers(const Eigen::VectorXd& parameters) const;
  std::vector<CumulativeLogit> answersAt(
      const Eigen::VectorXd& parameters, const Eigen::VectorXd& predictor) const;
  Eigen::VectorXd newtonStep(const Mode& mode);
  std::optional<Mode> findMode(const Eigen::VectorXd& parameters);
  /// R = L⁻¹P, where LLᵀ = PDPᵀ, so that D⁻¹ = RᵀR; as sparse as L.
  Sparse rootOfInverse() const;

  std::vector<std::size_t> y_;
  std::size_t thresholds_;
  Eigen::MatrixXd x_;
  /// For each intercept, a matrix whose column i is 1 at the level of answer i.
  std::vector<Sparse> indicators_;
  Eigen::SimplicialLLT<Sparse> system_;  ///< D at the last mode
  Eigen::VectorXd u_;  ///< û of the last mode; the search for the next mode starts there
};

}  // namespace analysis
