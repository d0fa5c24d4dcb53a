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

constexpr double kNothing = 1e-12;  // of a sum of squares

std::vector<double> rowByRow(const MatrixXd& matrix) {
  std::vector<double> numbers;
  for (Index i = 0; i < matrix.rows(); ++i) {
    for (Index j = 0; j < matrix.cols(); ++j) numbers.push_back(matrix(i, j));
  }
  return numbers;
}

std::vector<double> toVector(const VectorXd& vector) {
  return {vector.begin(), vector.end()};
}

}  // namespace

struct RestrictedDeviance::Parts {
  /// Everything at one φ that does not need a derivative.
  struct Profile {
    VectorXd root;  // √φ of each random effect
    Eigen::LLT<MatrixXd> system;
    MatrixXd reducedX;  // L⁻¹ΛZᵀX
    VectorXd reducedY;
    Eigen::LLT<MatrixXd> information;  // XᵀV⁻¹X
    VectorXd shift;                    // of the coefficients from those of least squares
    double residual = 0.0;             // r²
    double deviance = 0.0;
  };

  /// Z'PZ, Z'Py and Z'V⁻¹X.
  struct Projection {
    MatrixXd zpz;
    VectorXd zpy;
    MatrixXd zvx;
  };

  /// With V_k = Z_kZ_kᵀ: tr(PV_k), yᵀPV_kPy, tr(PV_kPV_l) and yᵀPV_kPV_lPy.
  struct Forms {
    VectorXd trace;
    VectorXd form;
    MatrixXd traces;
    MatrixXd forms;
  };

  Index answers = 0;
  Index columns = 0;
  std::vector<Index> begin;   // of each intercept among the random effects, and the end
  double offset = 0.0;        // y of the first answer, taken from all
  double sumOfSquares = 0.0;  // of y around its mean
  double leastSquares = 0.0;  // of what the fixed effects leave
  MatrixXd triangle;          // X = orthonormal × triangle
  VectorXd coefficients;      // of least squares, orthonormal
  MatrixXd ztz;
  MatrixXd ztx;
  VectorXd zty;

  Index intercepts() const { return static_cast<Index>(begin.size()) - 1; }
  Index effects() const { return begin.back(); }
  Index from(Index k) const { return begin[static_cast<std::size_t>(k)]; }
  Index levels(Index k) const { return from(k + 1) - from(k); }
  double degreesOfFreedom() const { return static_cast<double>(answers - columns); }

  void addFixed(std::span<const double> y, const FixedEffects& fixed, MatrixXd& x, VectorXd& rest);
  void addRandom(std::span<const Factor> random, const MatrixXd& x, const VectorXd& rest);
  std::optional<Profile> profileAt(std::span<const double> variances) const;
  Projection projectionOf(const Profile& profile) const;
  Forms formsOf(const Projection& projection) const;
  MatrixXd varianceHessian(
      const Projection& projection, double variance, const VectorXd& relative) const;
};

void RestrictedDeviance::Parts::addFixed(
    std::span<const double> y, const FixedEffects& fixed, MatrixXd& x, VectorXd& rest) {
  for (Index j = 0; j < columns; ++j) {
    const auto column = fixed.column(static_cast<std::size_t>(j));
    x.col(j) = Eigen::Map<const VectorXd>(column.data(), answers);
  }
  const Eigen::HouseholderQR<MatrixXd> qr(x);
  triangle = qr.matrixQR().topRows(columns).triangularView<Eigen::Upper>();
  x = qr.householderQ() * MatrixXd::Identity(answers, columns);

  rest = Eigen::Map<const VectorXd>(y.data(), answers);
  offset = rest(0);
  rest.array() -= offset;
  sumOfSquares = (rest.array() - rest.mean()).matrix().squaredNorm();
  coefficients = x.transpose() * rest;
  rest -= x * coefficients;
  const VectorXd correction = x.transpose() * rest;  // what rounding left of X in the residuals
  coefficients += correction;
  rest -= x * correction;
  leastSquares = rest.squaredNorm();
}

void RestrictedDeviance::Parts::addRandom(
    std::span<const Factor> random, const MatrixXd& x, const VectorXd& rest) {
  begin = {0};
  for (const auto& factor : random) {
    begin.push_back(begin.back() + static_cast<Index>(factor.levels.size()));
  }
  ztz = MatrixXd::Zero(effects(), effects());
  ztx = MatrixXd::Zero(effects(), columns);
  zty = VectorXd::Zero(effects());
  for (Index i = 0; i < answers; ++i) {
    const auto answer = static_cast<std::size_t>(i);
    for (std::size_t k = 0; k < random.size(); ++k) {
      const Index row = begin[k] + static_cast<Index>(random[k].levelOfAnswer[answer]);
      ztx.row(row) += x.row(i);
      zty(row) += rest(i);
      for (std::size_t l = 0; l < random.size(); ++l) {
        ztz(row, begin[l] + static_cast<Index>(random[l].levelOfAnswer[answer])) += 1.0;
      }
    }
  }
}

/// With Λ = diag(√φ): L Lᵀ = I + ΛZᵀZΛ, and V⁻¹ = I − ZΛ (L Lᵀ)⁻¹ ΛZᵀ.
std::optional<RestrictedDeviance::Parts::Profile> RestrictedDeviance::Parts::profileAt(
    std::span<const double> variances) const {
  Profile at;
  at.root = VectorXd::Zero(effects());
  for (Index k = 0; k < intercepts(); ++k) {
    at.root.segment(from(k), levels(k))
        .setConstant(std::sqrt(variances[static_cast<std::size_t>(k)]));
  }
  MatrixXd system = at.root.asDiagonal() * ztz * at.root.asDiagonal();
  system.diagonal().array() += 1.0;
  at.system.compute(system);

  at.reducedX = at.system.matrixL().solve(at.root.asDiagonal() * ztx);
  at.reducedY = at.system.matrixL().solve(at.root.asDiagonal() * zty);
  at.information.compute(
      MatrixXd::Identity(columns, columns) - at.reducedX.transpose() * at.reducedX);
  const VectorXd right = -at.reducedX.transpose() * at.reducedY;
  at.shift = at.information.solve(right);
  at.residual = leastSquares - at.reducedY.squaredNorm() - right.dot(at.shift);
  const bool isSolved =
      at.system.info() == Eigen::Success && at.information.info() == Eigen::Success;
  if (!isSolved || !(at.residual > kNothing * leastSquares)) return std::nullopt;

  const double df = degreesOfFreedom();
  const double logDeterminants = at.system.matrixLLT().diagonal().array().log().sum() +
                                 at.information.matrixLLT().diagonal().array().log().sum() +
                                 triangle.diagonal().array().abs().log().sum();
  at.deviance =
      2.0 * logDeterminants + df * (1.0 + std::log(2.0 * std::numbers::pi * at.residual / df));
  if (!std::isfinite(at.deviance)) return std::nullopt;
  return at;
}

RestrictedDeviance::Parts::Projection RestrictedDeviance::Parts::projectionOf(
    const Profile& at) const {
  const MatrixXd reducedZ = at.system.matrixL().solve(at.root.asDiagonal() * ztz);
  Projection projection;
  projection.zvx = ztx - reducedZ.transpose() * at.reducedX;
  const MatrixXd half = at.information.matrixL().solve(projection.zvx.transpose());
  projection.zpz = ztz;
  projection.zpz.noalias() -= reducedZ.transpose() * reducedZ;
  projection.zpz.noalias() -= half.transpose() * half;
  projection.zpy = zty - reducedZ.transpose() * at.reducedY - projection.zvx * at.shift;
  return projection;
}

RestrictedDeviance::Parts::Forms RestrictedDeviance::Parts::formsOf(
    const Projection& projection) const {
  const Index size = intercepts();
  Forms of{
      .trace = VectorXd(size),
      .form = VectorXd(size),
      .traces = MatrixXd(size, size),
      .forms = MatrixXd(size, size)};
  for (Index k = 0; k < size; ++k) {
    const auto yk = projection.zpy.segment(from(k), levels(k));
    of.trace(k) = projection.zpz.diagonal().segment(from(k), levels(k)).sum();
    of.form(k) = yk.squaredNorm();
    for (Index l = 0; l < size; ++l) {
      const auto block = projection.zpz.block(from(k), from(l), levels(k), levels(l));
      of.traces(k, l) = block.squaredNorm();
      of.forms(k, l) = yk.dot(block * projection.zpy.segment(from(l), levels(l)));
    }
  }
  return of;
}

/// −tr(PV_iPV_j) + 2 yᵀPV_iPV_jPy for the variances of the intercepts and, last, of the residuals,
/// whose terms follow from PVP = P.
MatrixXd RestrictedDeviance::Parts::varianceHessian(
    const Projection& projection, double variance, const VectorXd& relative) const {
  const Index last = intercepts();
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

RestrictedDeviance::RestrictedDeviance(
    std::span<const double> y, const FixedEffects& fixed, std::span<const Factor> random) {
  auto parts = std::make_unique<Parts>();
  parts->answers = static_cast<Index>(y.size());
  parts->columns = static_cast<Index>(fixed.columns());
  MatrixXd x(parts->answers, parts->columns);
  VectorXd rest;
  parts->addFixed(y, fixed, x, rest);
  parts->addRandom(random, x, rest);
  parts_ = std::move(parts);
}

RestrictedDeviance::~RestrictedDeviance() = default;

bool RestrictedDeviance::isExplainedByFixedEffects() const {
  return !(parts_->leastSquares > kNothing * parts_->sumOfSquares);
}

bool RestrictedDeviance::isExplainedByFixedEffects(std::size_t intercept) const {
  const auto k = static_cast<Index>(intercept);
  const Index from = parts_->from(k);
  const Index levels = parts_->levels(k);
  const double left =
      static_cast<double>(parts_->answers) - parts_->ztx.middleRows(from, levels).squaredNorm();
  return left < kNothing * static_cast<double>(parts_->answers);
}

std::optional<double> RestrictedDeviance::value(std::span<const double> relativeVariances) const {
  const auto at = parts_->profileAt(relativeVariances);
  return at ? std::optional(at->deviance) : std::nullopt;
}

std::optional<Derivatives> RestrictedDeviance::derivatives(
    std::span<const double> relativeVariances) const {
  const auto at = parts_->profileAt(relativeVariances);
  if (!at) return std::nullopt;
  auto [trace, form, traces, forms] = parts_->formsOf(parts_->projectionOf(*at));

  const double df = parts_->degreesOfFreedom();
  form *= df / at->residual;
  forms *= df / at->residual;
  return Derivatives{
      .gradient = toVector(trace - form),
      .hessian = rowByRow(-traces + 2.0 * forms - form * form.transpose() / df)};
}

std::optional<RestrictedSolution> RestrictedDeviance::solution(
    std::span<const double> relativeVariances) const {
  const auto at = parts_->profileAt(relativeVariances);
  if (!at) return std::nullopt;
  const auto projection = parts_->projectionOf(*at);
  const Index size = parts_->intercepts();
  const VectorXd relative = Eigen::Map<const VectorXd>(relativeVariances.data(), size);
  const auto upper = parts_->triangle.triangularView<Eigen::Upper>();
  const MatrixXd inverse = upper.solve(MatrixXd::Identity(parts_->columns, parts_->columns));
  const MatrixXd half = at->information.solve(inverse.transpose());
  const MatrixXd covariance = inverse * half;  // relative to σ²

  RestrictedSolution solution;
  solution.deviance = at->deviance;
  solution.residualVariance = at->residual / parts_->degreesOfFreedom();
  solution.coefficients = toVector(inverse * (parts_->coefficients + at->shift));
  solution.coefficients[0] += parts_->offset;  // the intercept
  solution.covariance = rowByRow(solution.residualVariance * covariance);
  MatrixXd ofResiduals = covariance;
  for (Index k = 0; k < size; ++k) {
    const MatrixXd root = projection.zvx.middleRows(parts_->from(k), parts_->levels(k)) * half;
    const MatrixXd ofIntercept = root.transpose() * root;
    ofResiduals -= relative(k) * ofIntercept;
    solution.covarianceDerivatives.push_back(rowByRow(ofIntercept));
  }
  solution.covarianceDerivatives.push_back(rowByRow(ofResiduals));
  solution.hessian =
      rowByRow(parts_->varianceHessian(projection, solution.residualVariance, relative));
  return solution;
}

}  // namespace analysis
