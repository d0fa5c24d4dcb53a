#include "analysis/models/linear_mixed_model.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "analysis/models/mixed_model_design.h"
#include "analysis/models/restricted_deviance.h"
#include "analysis/numerics/newton_minimum.h"
#include "analysis/numerics/student_distribution.h"

namespace analysis {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double kSingular = 1e-4;        // standard deviation, of that of the residuals
constexpr double kLargestStretch = 40.0;  // e^40: beyond it no residual variance is left
constexpr double kStarts[] = {0.5, 2.0};

Eigen::Map<const Matrix> square(const std::vector<double>& numbers, std::size_t size) {
  const auto side = static_cast<Eigen::Index>(size);
  return {numbers.data(), side, side};
}

/// The deviance as a function of s_k = ln(1 + m_k φ_k), with m_k the mean number of answers per
/// level. With one intercept and balanced data it is convex in s, which it is not in φ.
class Stretched {
 public:
  Stretched(const RestrictedDeviance& deviance, std::span<const Factor> random)
      : deviance_(deviance) {
    for (const auto& factor : random) {
      answersPerLevel_.push_back(
          static_cast<double>(factor.levelOfAnswer.size()) /
          static_cast<double>(factor.levels.size()));
    }
  }

  std::vector<double> relativeVariances(std::span<const double> s) const {
    std::vector<double> variances;
    for (std::size_t k = 0; k < s.size(); ++k) {
      variances.push_back(std::expm1(s[k]) / answersPerLevel_[k]);
    }
    return variances;
  }

  std::optional<double> value(std::span<const double> s) const {
    const auto isTooLarge = [](double stretch) { return stretch > kLargestStretch; };
    if (std::ranges::any_of(s, isTooLarge)) return std::nullopt;
    return deviance_.value(relativeVariances(s));
  }

  std::optional<Derivatives> derivatives(std::span<const double> s) const {
    auto derivatives = deviance_.derivatives(relativeVariances(s));
    if (!derivatives) return std::nullopt;
    const std::size_t size = s.size();
    for (std::size_t k = 0; k < size; ++k) {
      const double slope = std::exp(s[k]) / answersPerLevel_[k];
      for (std::size_t l = 0; l < size; ++l) {
        derivatives->hessian[k * size + l] *= slope;
        derivatives->hessian[l * size + k] *= slope;
      }
      derivatives->gradient[k] *= slope;
      derivatives->hessian[k * size + k] += derivatives->gradient[k];
    }
    return derivatives;
  }

 private:
  const RestrictedDeviance& deviance_;
  std::vector<double> answersPerLevel_;
};

std::optional<Minimum> smallestDeviance(const Stretched& stretched, std::size_t intercepts) {
  const Objective objective{
      .value = [&](auto s) { return stretched.value(s); },
      .derivatives = [&](auto s) { return stretched.derivatives(s); },
      .lowerBound = 0.0};
  std::optional<Minimum> best;
  for (const double start : kStarts) {
    auto minimum = minimise(objective, std::vector<double>(intercepts, start));
    if (minimum.isFound && (!best || minimum.value < best->value)) best = std::move(minimum);
  }
  return best;
}

Reason whyNotDefinedHere(const RestrictedDeviance& deviance, std::span<const Factor> random) {
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

/// Twice the inverse Hessian in the variances that are not zero; a variance estimated as zero
/// counts as known. Empty where the deviance does not curve upwards.
std::vector<double> varianceCovariance(
    const RestrictedSolution& solution, std::span<const double> relative) {
  const std::size_t size = relative.size() + 1;
  std::vector<Eigen::Index> used;
  for (std::size_t k = 0; k < size; ++k) {
    if (k == relative.size() || relative[k] > 0.0) used.push_back(static_cast<Eigen::Index>(k));
  }
  const double scale = solution.residualVariance * solution.residualVariance;
  const Matrix hessian = scale * square(solution.hessian, size)(used, used);
  const Eigen::LLT<Matrix> cholesky(hessian);
  if (cholesky.info() != Eigen::Success || !(cholesky.rcond() > 1e-14)) return {};

  const auto side = static_cast<Eigen::Index>(size);
  Matrix covariance = Matrix::Zero(side, side);
  covariance(used, used) =
      2.0 * scale * cholesky.solve(Matrix::Identity(hessian.rows(), hessian.cols()));
  return {covariance.data(), covariance.data() + covariance.size()};
}

std::optional<double> satterthwaite(const LinearMixedFit& fit, const Eigen::VectorXd& weights) {
  if (fit.varianceCovariance.empty()) return std::nullopt;
  const auto size = static_cast<std::size_t>(weights.size());
  const std::size_t variances = fit.covarianceDerivatives.size();
  Eigen::VectorXd gradient(static_cast<Eigen::Index>(variances));
  for (std::size_t k = 0; k < variances; ++k) {
    gradient(static_cast<Eigen::Index>(k)) =
        weights.dot(square(fit.covarianceDerivatives[k], size) * weights);
  }
  const double variance = weights.dot(square(fit.covariance, size) * weights);
  const double spread = gradient.dot(square(fit.varianceCovariance, variances) * gradient);
  const double df = 2.0 * variance * variance / spread;
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
  const StudentDistribution law(*estimate.degreesOfFreedom);
  estimate.p = law.twoSidedP(*estimate.t);
  estimate.log10P = law.log10TwoSidedP(*estimate.t);
}

TEstimate estimateOf(
    const LinearMixedFit& fit, std::string name, double value, const Eigen::VectorXd& weights) {
  const auto size = static_cast<std::size_t>(weights.size());
  TEstimate estimate{.name = std::move(name), .estimate = value};
  estimate.standardError =
      std::sqrt(std::max(0.0, weights.dot(square(fit.covariance, size) * weights)));
  estimate.degreesOfFreedom = satterthwaite(fit, weights);
  addTest(estimate);
  return estimate;
}

LinearMixedFit fitOf(
    const RestrictedSolution& solution,
    const FixedEffects& fixed,
    std::span<const Factor> random,
    std::span<const double> relative) {
  LinearMixedFit fit{
      .answers = fixed.answers(),
      .fixedEffects = {},
      .components = {},
      .residualVariance = solution.residualVariance,
      .logLikelihood = -0.5 * solution.deviance,
      .covariance = solution.covariance,
      .covarianceDerivatives = solution.covarianceDerivatives,
      .varianceCovariance = varianceCovariance(solution, relative)};
  for (std::size_t k = 0; k < random.size(); ++k) {
    const double variance = relative[k] * fit.residualVariance;
    fit.components.push_back(
        {.name = random[k].name,
         .levels = random[k].levels.size(),
         .variance = variance,
         .standardDeviation = std::sqrt(variance),
         .isSingular = std::sqrt(relative[k]) < kSingular});
  }
  const auto columns = static_cast<Eigen::Index>(fixed.columns());
  for (Eigen::Index j = 0; j < columns; ++j) {
    const auto column = static_cast<std::size_t>(j);
    fit.fixedEffects.push_back(estimateOf(
        fit, fixed.name(column), solution.coefficients[column], Eigen::VectorXd::Unit(columns, j)));
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
  result.reason = whyNotDefinedHere(deviance, random);
  if (!result.reason.empty()) return result;

  const Stretched stretched(deviance, random);
  const auto minimum = smallestDeviance(stretched, random.size());
  const auto relative = minimum ? stretched.relativeVariances(minimum->at) : std::vector<double>();
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
  const Eigen::Map<const Eigen::VectorXd> vector(
      weights.data(), static_cast<Eigen::Index>(weights.size()));
  return estimateOf(fit, std::move(name), value, vector);
}

std::vector<TEstimate> marginalMeans(
    const LinearMixedFit& fit, const FixedEffects& fixed, std::string_view factor) {
  std::vector<TEstimate> means;
  for (const auto& level : fixed.factor(factor).levels) {
    means.push_back(contrast(fit, level, fixed.marginalMean(factor, level)));
  }
  return means;
}

std::vector<TEstimate> pairwiseDifferences(
    const LinearMixedFit& fit, const FixedEffects& fixed, std::string_view factor) {
  std::vector<TEstimate> differences;
  const auto& levels = fixed.factor(factor).levels;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    for (std::size_t j = i + 1; j < levels.size(); ++j) {
      const auto weights = fixed.difference(factor, levels[i], levels[j]);
      differences.push_back(contrast(fit, levels[i] + " - " + levels[j], weights));
    }
  }
  return differences;
}

std::optional<Interval> confidenceInterval(const TEstimate& estimate, double level) {
  if (!(level > 0.0 && level < 1.0)) {
    throw std::invalid_argument("a confidence level lies between 0 and 1");
  }
  if (!estimate.p || !estimate.degreesOfFreedom) return std::nullopt;
  const StudentDistribution law(*estimate.degreesOfFreedom);
  const double reach = law.twoSidedQuantile(1.0 - level) * estimate.standardError;
  if (!std::isfinite(reach)) return std::nullopt;
  return Interval{.low = estimate.estimate - reach, .high = estimate.estimate + reach};
}

}  // namespace analysis
