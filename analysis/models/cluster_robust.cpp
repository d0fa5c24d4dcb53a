#include "analysis/models/cluster_robust.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Dense>

#include "analysis/numerics/distributions.h"

namespace analysis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Matrices of one cluster, with Q_g its rows of the orthonormalised X.
struct Cluster {
  MatrixXd square;  ///< S = Q_gᵀQ_g
  MatrixXd root;    ///< M with A_g Q_g = Q_g M: (I − S)^{−1/2}
  VectorXd score;   ///< Q_gᵀe_g
};

struct LeastSquares {
  MatrixXd inverse;  ///< R⁻¹ of X = QR
  VectorXd coefficients;
  double spread = 0.0;  ///< |e|² / |y − mean|²
  std::vector<Cluster> clusters;
};

/// The pseudo-inverse of (I − S)^{1/2}: eigenvalues of S that are one give zero.
MatrixXd pseudoInverseRoot(const MatrixXd& square) {
  constexpr double kZeroEigenvalue = 1e-10;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(square);
  const VectorXd factors = eigen.eigenvalues().unaryExpr([](double value) {
    return 1.0 - value > kZeroEigenvalue ? 1.0 / std::sqrt(1.0 - value) : 0.0;
  });
  return eigen.eigenvectors() * factors.asDiagonal() * eigen.eigenvectors().transpose();
}

LeastSquares leastSquares(
    std::span<const double> y, const FixedEffects& fixed, const Factor& cluster) {
  const auto rows = static_cast<Index>(y.size());
  const auto columns = static_cast<Index>(fixed.columns());
  MatrixXd x(rows, columns);
  for (Index j = 0; j < columns; ++j) {
    x.col(j) = Eigen::Map<const VectorXd>(fixed.column(static_cast<std::size_t>(j)).data(), rows);
  }
  const Eigen::HouseholderQR<MatrixXd> qr(x);
  const MatrixXd q = qr.householderQ() * MatrixXd::Identity(rows, columns);
  const MatrixXd triangle = qr.matrixQR().topRows(columns).triangularView<Eigen::Upper>();

  LeastSquares fit;
  fit.inverse = triangle.triangularView<Eigen::Upper>().solve(MatrixXd::Identity(columns, columns));
  const VectorXd values = Eigen::Map<const VectorXd>(y.data(), rows).array() - y[0];
  const VectorXd projection = q.transpose() * values;
  const VectorXd residuals = values - q * projection;
  fit.coefficients = fit.inverse * projection;
  fit.coefficients(0) += y[0];  // the intercept
  const double total = (values.array() - values.mean()).matrix().squaredNorm();
  fit.spread = total > 0.0 ? residuals.squaredNorm() / total : 0.0;

  const Cluster none{MatrixXd::Zero(columns, columns), {}, VectorXd::Zero(columns)};
  fit.clusters.assign(cluster.levels.size(), none);
  for (Index i = 0; i < rows; ++i) {
    auto& own = fit.clusters[cluster.levelOfAnswer[static_cast<std::size_t>(i)]];
    own.square += q.row(i).transpose() * q.row(i);
    own.score += q.row(i).transpose() * residuals(i);
  }
  for (auto& own : fit.clusters) own.root = pseudoInverseRoot(own.square);
  return fit;
}

/// Satterthwaite's (Σ p_gᵀp_g)² / ΣΣ (p_gᵀp_h)², with p_g = (I − H)_g A_g Q_g c.
double degreesOfFreedom(const std::vector<Cluster>& clusters, const VectorXd& weights) {
  std::vector<VectorXd> projectedWeights;  // S_g M_g c
  for (const auto& own : clusters) projectedWeights.emplace_back(own.square * (own.root * weights));
  double trace = 0.0;
  double squares = 0.0;
  for (std::size_t g = 0; g < clusters.size(); ++g) {
    const double self = projectedWeights[g].dot(clusters[g].root * weights);
    for (std::size_t h = 0; h < clusters.size(); ++h) {
      const double product = (g == h ? self : 0.0) - projectedWeights[g].dot(projectedWeights[h]);
      squares += product * product;
      if (g == h) trace += product;
    }
  }
  return trace * trace / squares;
}

TEstimate estimateOf(const LeastSquares& fit, Index column, const std::string& name) {
  const VectorXd weights = fit.inverse.row(column).transpose();
  double variance = 0.0;
  for (const auto& own : fit.clusters) {
    variance += std::pow(own.score.dot(own.root * weights), 2);
  }
  TEstimate estimate{.name = name, .estimate = fit.coefficients(column)};
  estimate.standardError = std::sqrt(variance);
  const double df = degreesOfFreedom(fit.clusters, weights);
  if (!(variance > 0.0) || !std::isfinite(df)) {
    estimate.reason = reason("no_standard_error");
    return estimate;
  }
  estimate.t = estimate.estimate / estimate.standardError;
  estimate.degreesOfFreedom = df;
  // Student's t distribution needs one degree of freedom; rounding may make exactly one a little
  // less.
  if (df < 1.0 - 1e-9) {
    estimate.reason = reason("too_few_clusters");
    return estimate;
  }
  const StudentDistribution distribution(std::max(df, 1.0));
  estimate.p = distribution.twoSidedP(*estimate.t);
  estimate.log10P = distribution.log10TwoSidedP(*estimate.t);
  return estimate;
}

}  // namespace

ClusterRobustResult clusterRobust(
    std::span<const double> y, const FixedEffects& fixed, const Factor& cluster) {
  const auto isFinite = [](double value) { return std::isfinite(value); };
  if (y.size() != fixed.answers() || cluster.levelOfAnswer.size() != y.size() ||
      !std::ranges::all_of(y, isFinite)) {
    throw std::invalid_argument("least squares needs a finite number and a cluster per answer");
  }
  ClusterRobustResult result;
  result.reason = whyNotDefined(fixed, {});
  if (result.reason.empty() && cluster.levels.size() < 2) {
    result.reason = reason("one_level", cluster.name);
  }
  if (!result.reason.empty()) return result;

  const LeastSquares fit = leastSquares(y, fixed, cluster);
  // Residuals of 1e-12 of the spread are what rounding leaves of an exact fit.
  if (!(fit.spread > 1e-24)) {
    result.reason = reason("no_variance_beyond_fixed");
    return result;
  }
  for (std::size_t j = 0; j < fixed.columns(); ++j) {
    result.fixedEffects.push_back(estimateOf(fit, static_cast<Index>(j), fixed.name(j)));
  }
  return result;
}

}  // namespace analysis
