#include "analysis/models/linear_mixed_model.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "analysis/models/restricted_deviance.h"
#include "analysis/numerics/distributions.h"
#include "analysis/numerics/newton_minimum.h"

namespace analysis {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Eigen::VectorXd;

// Smaller standard deviations, relative to that of the residuals, count as 0.
constexpr double kSingular = 1e-4;
constexpr double kLargestLog = 40.0;  // e^40: beyond it no residual variance is left
constexpr double kFlat = 1e-14;       // reciprocal condition of a Hessian that has no inverse
// Starting values of the random standard deviations, relative to that of the residuals; two, since
// the deviance may have a second minimum.
constexpr double kStartingDeviations[] = {0.5, 2.0};

/// The quadratic form weightsᵀ · matrix · weights.
double quadraticForm(const VectorXd& weights, const std::vector<double>& matrix) {
  return weights.dot(Matrix::Map(matrix.data(), weights.size(), weights.size()) * weights);
}

std::vector<double> rowByRow(const Matrix& matrix) {
  return {matrix.data(), matrix.data() + matrix.size()};
}

/// The deviance as a function of s_k = ln(1 + m_k φ_k), with m_k the mean number of answers per
/// level. With one intercept and balanced data the deviance is convex in s, but not in φ.
class LogScaleDeviance {
 public:
  LogScaleDeviance(const RestrictedDeviance& deviance, std::span<const Factor> random)
      : deviance_(deviance), answersPerLevel_(static_cast<Eigen::Index>(random.size())) {
    for (Eigen::Index k = 0; const auto& factor : random) {
      answersPerLevel_(k++) = static_cast<double>(factor.levelOfAnswer.size()) /
                              static_cast<double>(factor.levels.size());
    }
  }

  VectorXd relativeVariances(const VectorXd& s) const {
    return s.unaryExpr([](double log) { return std::expm1(log); }).cwiseQuotient(answersPerLevel_);
  }

  std::optional<double> value(const VectorXd& s) const {
    if ((s.array() > kLargestLog).any()) return std::nullopt;
    return deviance_.value(relativeVariances(s));
  }

  /// By the chain rule: dφ_k/ds_k = d²φ_k/ds_k² = e^{s_k} / m_k.
  std::optional<Derivatives> derivatives(const VectorXd& s) const {
    auto derivatives = deviance_.derivatives(relativeVariances(s));
    if (!derivatives) return std::nullopt;
    const VectorXd slope = s.array().exp() / answersPerLevel_.array();
    derivatives->gradient.array() *= slope.array();
    derivatives->hessian = slope.asDiagonal() * derivatives->hessian * slope.asDiagonal();
    derivatives->hessian.diagonal() += derivatives->gradient;
    return derivatives;
  }

 private:
  const RestrictedDeviance& deviance_;
  VectorXd answersPerLevel_;
};

std::optional<Minimum> smallestDeviance(const LogScaleDeviance& logScale, Eigen::Index intercepts) {
  const Objective objective{
      .value = [&](const VectorXd& s) { return logScale.value(s); },
      .derivatives = [&](const VectorXd& s) { return logScale.derivatives(s); },
      .lowerBound = 0.0};
  std::optional<Minimum> best;
  for (const double start : kStartingDeviations) {
    auto minimum = minimise(objective, VectorXd::Constant(intercepts, start));
    if (minimum.isFound && (!best || minimum.value < best->value)) best = std::move(minimum);
  }
  return best;
}

Reason whyModelIsNotDefined(const RestrictedDeviance& deviance, std::span<const Factor> random) {
  if (deviance.isExplainedByFixedEffects()) {
    return reason("no_spread_beyond_fixed");
  }
  for (std::size_t k = 0; k < random.size(); ++k) {
    if (deviance.isExplainedByFixedEffects(k)) {
      return reason("nothing_left_of_intercept", random[k].name);
    }
  }
  return {};
}

/// Twice the inverse Hessian of the restricted deviance with respect to the variances that are not
/// zero; a variance estimated as zero is treated as known. Empty if the Hessian is not positive
/// definite.
Matrix varianceCovariance(const RestrictedSolution& solution, const VectorXd& relative) {
  std::vector<Eigen::Index> used;
  for (Eigen::Index k = 0; k < relative.size(); ++k) {
    if (relative(k) > 0.0) used.push_back(k);
  }
  used.push_back(relative.size());  // of the residuals
  // In units of σ⁴, so that the condition number does not depend on the unit of the answers.
  const double scale = solution.residualVariance * solution.residualVariance;
  const Matrix hessian = scale * solution.hessian(used, used);
  const Eigen::LLT<Matrix> cholesky(hessian);
  if (cholesky.info() != Eigen::Success || !(cholesky.rcond() > kFlat)) return {};

  Matrix covariance = Matrix::Zero(relative.size() + 1, relative.size() + 1);
  covariance(used, used) =
      2.0 * scale * cholesky.solve(Matrix::Identity(hessian.rows(), hessian.cols()));
  return covariance;
}

std::optional<double> satterthwaite(const LinearMixedFit& fit, const VectorXd& weights) {
  if (fit.varianceCovariance.empty()) return std::nullopt;
  const auto variances = static_cast<Eigen::Index>(fit.covarianceDerivatives.size());
  VectorXd gradient(variances);
  for (Eigen::Index k = 0; const auto& derivative : fit.covarianceDerivatives) {
    gradient(k++) = quadraticForm(weights, derivative);
  }
  const double variance = quadraticForm(weights, fit.covariance);
  const double df = 2.0 * variance * variance / quadraticForm(gradient, fit.varianceCovariance);
  return std::isfinite(df) && df > 0.0 ? std::optional(df) : std::nullopt;
}

void addTest(TEstimate& estimate) {
  if (!(estimate.standardError > 0.0)) {
    estimate.reason = reason("no_standard_error");
    return;
  }
  estimate.t = estimate.estimate / estimate.standardError;
  if (!estimate.degreesOfFreedom) {
    estimate.reason = reason("likelihood_too_flat");
    return;
  }
  if (*estimate.degreesOfFreedom < 1.0) {
    estimate.reason = reason("too_few_levels");
    return;
  }
  const StudentDistribution distribution(*estimate.degreesOfFreedom);
  estimate.p = distribution.twoSidedP(*estimate.t);
  estimate.log10P = distribution.log10TwoSidedP(*estimate.t);
}

TEstimate estimateOf(
    const LinearMixedFit& fit, std::string name, double value, const VectorXd& weights) {
  TEstimate estimate{.name = std::move(name), .estimate = value};
  estimate.standardError = std::sqrt(std::max(0.0, quadraticForm(weights, fit.covariance)));
  estimate.degreesOfFreedom = satterthwaite(fit, weights);
  addTest(estimate);
  return estimate;
}

LinearMixedFit fitOf(
    const RestrictedSolution& solution,
    const FixedEffects& fixed,
    std::span<const Factor> random,
    const VectorXd& relative) {
  LinearMixedFit fit{
      .answers = fixed.answers(),
      .fixedEffects = {},
      .components = {},
      .residualVariance = solution.residualVariance,
      .logLikelihood = -0.5 * solution.deviance,
      .covariance = rowByRow(solution.covariance),
      .covarianceDerivatives = {},
      .varianceCovariance = rowByRow(varianceCovariance(solution, relative))};
  for (const auto& derivative : solution.covarianceDerivatives) {
    fit.covarianceDerivatives.push_back(rowByRow(derivative));
  }
  for (Eigen::Index k = 0; const auto& factor : random) {
    const double variance = relative(k) * fit.residualVariance;
    fit.components.push_back(
        {.name = factor.name,
         .levels = factor.levels.size(),
         .variance = variance,
         .standardDeviation = std::sqrt(variance),
         .isSingular = std::sqrt(relative(k)) < kSingular});
    ++k;
  }
  const Eigen::Index columns = solution.coefficients.size();
  for (Eigen::Index j = 0; j < columns; ++j) {
    const auto& name = fixed.name(static_cast<std::size_t>(j));
    fit.fixedEffects.push_back(
        estimateOf(fit, name, solution.coefficients(j), VectorXd::Unit(columns, j)));
  }
  return fit;
}

}  // namespace

LinearMixedResult fitLinearMixedModel(
    std::span<const double> y, const FixedEffects& fixed, std::span<const Factor> random) {
  const auto isFinite = [](double value) { return std::isfinite(value); };
  if (y.size() != fixed.answers() || !std::ranges::all_of(y, isFinite)) {
    throw std::invalid_argument("a mixed model needs a finite number for each answer");
  }
  LinearMixedResult result;
  result.reason = whyNotDefined(fixed, random);
  if (!result.reason.empty()) return result;

  const RestrictedDeviance deviance(y, fixed, random);
  result.reason = whyModelIsNotDefined(deviance, random);
  if (!result.reason.empty()) return result;

  const LogScaleDeviance logScale(deviance, random);
  const auto minimum = smallestDeviance(logScale, static_cast<Eigen::Index>(random.size()));
  const VectorXd relative = minimum ? logScale.relativeVariances(minimum->at) : VectorXd();
  const auto solution = minimum ? deviance.solution(relative) : std::nullopt;
  if (!solution) {
    result.reason = reason("variances_not_estimated");
    return result;
  }
  result.fit = fitOf(*solution, fixed, random, relative);
  result.fit->iterations = minimum->iterations;
  return result;
}

TEstimate contrast(const LinearMixedFit& fit, std::string name, std::span<const double> weights) {
  if (weights.size() != fit.fixedEffects.size()) {
    throw std::invalid_argument("a contrast needs one weight for each fixed effect");
  }
  double value = 0.0;
  for (std::size_t j = 0; j < weights.size(); ++j) {
    value += weights[j] * fit.fixedEffects[j].estimate;
  }
  const auto size = static_cast<Eigen::Index>(weights.size());
  return estimateOf(fit, std::move(name), value, VectorXd::Map(weights.data(), size));
}

}  // namespace analysis
