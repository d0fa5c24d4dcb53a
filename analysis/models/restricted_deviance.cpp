#include "analysis/models/restricted_deviance.h"

#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/Dense>
#include <Eigen/QR>

namespace analysis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Relative to a sum of squares: smaller values are rounding errors.
constexpr double kNegligible = 1e-12;

}  // namespace

/// The quantities at one φ that need no derivative. With Λ = diag(√φ): L Lᵀ = I + ΛZᵀZΛ, and V⁻¹ =
/// I − ZΛ (L Lᵀ)⁻¹ ΛZᵀ.
struct RestrictedDeviance::Profile {
  VectorXd root;  // √φ of each random effect
  Eigen::LLT<MatrixXd> system;
  MatrixXd reducedX;  // L⁻¹ΛZᵀX
  VectorXd reducedY;
  Eigen::LLT<MatrixXd> information;  // XᵀV⁻¹X
  VectorXd shift;                    // difference of the coefficients from those of least squares
  double residual = 0.0;             // r²
  double deviance = 0.0;
};

/// ZᵀPZ, ZᵀPy and ZᵀV⁻¹X.
struct RestrictedDeviance::Projection {
  MatrixXd zpz;
  VectorXd zpy;
  MatrixXd zvx;
};

/// With V_k = Z_kZ_kᵀ: tr(PV_k), yᵀPV_kPy, tr(PV_kPV_l) and yᵀPV_kPV_lPy.
struct RestrictedDeviance::QuadraticForms {
  VectorXd trace;
  VectorXd form;
  MatrixXd traces;
  MatrixXd forms;
};

RestrictedDeviance::RestrictedDeviance(
    std::span<const double> y, const FixedEffects& fixed, std::span<const Factor> random)
    : answers_(static_cast<Index>(y.size())), columns_(static_cast<Index>(fixed.columns())) {
  MatrixXd x(answers_, columns_);
  addFixed(y, fixed, x);
  addRandom(random, x);
}

void RestrictedDeviance::addFixed(
    std::span<const double> y, const FixedEffects& fixed, MatrixXd& x) {
  for (Index j = 0; j < columns_; ++j) {
    const auto column = fixed.column(static_cast<std::size_t>(j));
    x.col(j) = VectorXd::Map(column.data(), answers_);
  }
  const Eigen::HouseholderQR<MatrixXd> qr(x);
  triangularFactor_ = qr.matrixQR().topRows(columns_).triangularView<Eigen::Upper>();
  x = qr.householderQ() * MatrixXd::Identity(answers_, columns_);

  residuals_ = VectorXd::Map(y.data(), answers_);
  offset_ = residuals_(0);
  residuals_.array() -= offset_;
  sumOfSquares_ = (residuals_.array() - residuals_.mean()).matrix().squaredNorm();
  coefficients_ = x.transpose() * residuals_;
  residuals_ -= x * coefficients_;
  // Projects y on X a second time, because rounding left a part of X in the residuals.
  const VectorXd correction = x.transpose() * residuals_;
  coefficients_ += correction;
  residuals_ -= x * correction;
  residualSumOfSquares_ = residuals_.squaredNorm();
}

void RestrictedDeviance::addRandom(std::span<const Factor> random, const MatrixXd& x) {
  Index effects = 0;
  for (const auto& factor : random) {
    firstEffect_.push_back(effects);
    levels_.push_back(static_cast<Index>(factor.levels.size()));
    effects += levels_.back();
  }
  ztz_ = MatrixXd::Zero(effects, effects);
  ztx_ = MatrixXd::Zero(effects, columns_);
  zty_ = VectorXd::Zero(effects);
  for (Index i = 0; i < answers_; ++i) {
    const auto answer = static_cast<std::size_t>(i);
    for (std::size_t k = 0; k < random.size(); ++k) {
      const Index row = firstEffect_[k] + static_cast<Index>(random[k].levelOfAnswer[answer]);
      ztx_.row(row) += x.row(i);
      zty_(row) += residuals_(i);
      for (std::size_t l = 0; l < random.size(); ++l) {
        ztz_(row, firstEffect_[l] + static_cast<Index>(random[l].levelOfAnswer[answer])) += 1.0;
      }
    }
  }
}

std::optional<RestrictedDeviance::Profile> RestrictedDeviance::profileAt(
    const VectorXd& relativeVariances) const {
  Profile profile;
  profile.root = VectorXd::Zero(zty_.size());
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    const double variance = relativeVariances(static_cast<Index>(k));
    profile.root.segment(firstEffect_[k], levels_[k]).setConstant(std::sqrt(variance));
  }
  MatrixXd system = profile.root.asDiagonal() * ztz_ * profile.root.asDiagonal();
  system.diagonal().array() += 1.0;
  profile.system.compute(system);

  profile.reducedX = profile.system.matrixL().solve(profile.root.asDiagonal() * ztx_);
  profile.reducedY = profile.system.matrixL().solve(profile.root.asDiagonal() * zty_);
  profile.information.compute(
      MatrixXd::Identity(columns_, columns_) - profile.reducedX.transpose() * profile.reducedX);
  const VectorXd right = -profile.reducedX.transpose() * profile.reducedY;
  profile.shift = profile.information.solve(right);
  profile.residual =
      residualSumOfSquares_ - profile.reducedY.squaredNorm() - right.dot(profile.shift);
  const bool isSolved =
      profile.system.info() == Eigen::Success && profile.information.info() == Eigen::Success;
  if (!isSolved || !(profile.residual > kNegligible * residualSumOfSquares_)) return std::nullopt;

  const double df = degreesOfFreedom();
  const double logDeterminants = profile.system.matrixLLT().diagonal().array().log().sum() +
                                 profile.information.matrixLLT().diagonal().array().log().sum() +
                                 triangularFactor_.diagonal().array().abs().log().sum();
  profile.deviance =
      2.0 * logDeterminants + df * (1.0 + std::log(2.0 * std::numbers::pi * profile.residual / df));
  if (!std::isfinite(profile.deviance)) return std::nullopt;
  return profile;
}

RestrictedDeviance::Projection RestrictedDeviance::projectionOf(const Profile& profile) const {
  const MatrixXd reducedZ = profile.system.matrixL().solve(profile.root.asDiagonal() * ztz_);
  Projection projection;
  projection.zvx = ztx_ - reducedZ.transpose() * profile.reducedX;
  const MatrixXd half = profile.information.matrixL().solve(projection.zvx.transpose());
  projection.zpz = ztz_;
  projection.zpz.noalias() -= reducedZ.transpose() * reducedZ;
  projection.zpz.noalias() -= half.transpose() * half;
  projection.zpy = zty_ - reducedZ.transpose() * profile.reducedY - projection.zvx * profile.shift;
  return projection;
}

RestrictedDeviance::QuadraticForms RestrictedDeviance::formsOf(const Projection& projection) const {
  const auto size = static_cast<Index>(levels_.size());
  QuadraticForms of{
      .trace = VectorXd(size),
      .form = VectorXd(size),
      .traces = MatrixXd(size, size),
      .forms = MatrixXd(size, size)};
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    const auto row = static_cast<Index>(k);
    const auto yk = projection.zpy.segment(firstEffect_[k], levels_[k]);
    of.trace(row) = projection.zpz.diagonal().segment(firstEffect_[k], levels_[k]).sum();
    of.form(row) = yk.squaredNorm();
    for (std::size_t l = 0; l < levels_.size(); ++l) {
      const auto column = static_cast<Index>(l);
      const auto block =
          projection.zpz.block(firstEffect_[k], firstEffect_[l], levels_[k], levels_[l]);
      of.traces(row, column) = block.squaredNorm();
      of.forms(row, column) = yk.dot(block * projection.zpy.segment(firstEffect_[l], levels_[l]));
    }
  }
  return of;
}

/// −tr(PV_iPV_j) + 2 yᵀPV_iPV_jPy for the variances of the intercepts and, last, of the residuals,
/// whose terms follow from PVP = P.
MatrixXd RestrictedDeviance::varianceHessian(
    const Projection& projection, double variance, const VectorXd& relative) const {
  const Index last = relative.size();
  auto [trace, form, traces, forms] = formsOf(projection);
  form /= variance;
  forms /= variance;

  const VectorXd traceRow = trace - traces * relative;
  const VectorXd formRow = form - forms * relative;
  const double df = degreesOfFreedom();
  MatrixXd hessian(last + 1, last + 1);
  hessian.topLeftCorner(last, last) = -traces + 2.0 * forms;
  hessian.col(last).head(last) = -traceRow + 2.0 * formRow;
  hessian.row(last).head(last) = hessian.col(last).head(last).transpose();
  hessian(last, last) = -(df - relative.dot(trace) - relative.dot(traceRow)) +
                        2.0 * (df - relative.dot(form) - relative.dot(formRow));
  return hessian / (variance * variance);
}

bool RestrictedDeviance::isExplainedByFixedEffects() const {
  return !(residualSumOfSquares_ > kNegligible * sumOfSquares_);
}

bool RestrictedDeviance::isExplainedByFixedEffects(std::size_t intercept) const {
  const auto answers = static_cast<double>(answers_);
  const auto its = ztx_.middleRows(firstEffect_[intercept], levels_[intercept]);
  return answers - its.squaredNorm() < kNegligible * answers;
}

std::optional<double> RestrictedDeviance::value(const VectorXd& relativeVariances) const {
  const auto profile = profileAt(relativeVariances);
  return profile ? std::optional(profile->deviance) : std::nullopt;
}

std::optional<Derivatives> RestrictedDeviance::derivatives(
    const VectorXd& relativeVariances) const {
  const auto profile = profileAt(relativeVariances);
  if (!profile) return std::nullopt;
  auto [trace, form, traces, forms] = formsOf(projectionOf(*profile));

  const double df = degreesOfFreedom();
  form *= df / profile->residual;
  forms *= df / profile->residual;
  return Derivatives{
      .gradient = trace - form, .hessian = -traces + 2.0 * forms - form * form.transpose() / df};
}

std::optional<RestrictedSolution> RestrictedDeviance::solution(
    const VectorXd& relativeVariances) const {
  const auto profile = profileAt(relativeVariances);
  if (!profile) return std::nullopt;
  const auto projection = projectionOf(*profile);
  const auto upper = triangularFactor_.triangularView<Eigen::Upper>();
  const MatrixXd inverse = upper.solve(MatrixXd::Identity(columns_, columns_));
  const MatrixXd half = profile->information.solve(inverse.transpose());
  MatrixXd ofResiduals = inverse * half;  // the covariance, relative to σ²

  RestrictedSolution solution;
  solution.deviance = profile->deviance;
  solution.residualVariance = profile->residual / degreesOfFreedom();
  solution.coefficients = inverse * (coefficients_ + profile->shift);
  solution.coefficients(0) += offset_;  // the intercept
  solution.covariance = solution.residualVariance * ofResiduals;
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    const MatrixXd root = projection.zvx.middleRows(firstEffect_[k], levels_[k]) * half;
    solution.covarianceDerivatives.emplace_back(root.transpose() * root);
    ofResiduals -= relativeVariances(static_cast<Index>(k)) * solution.covarianceDerivatives.back();
  }
  solution.covarianceDerivatives.push_back(ofResiduals);
  solution.hessian = varianceHessian(projection, solution.residualVariance, relativeVariances);
  return solution;
}

}  // namespace analysis
