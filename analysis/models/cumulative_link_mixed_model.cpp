#include "analysis/models/cumulative_link_mixed_model.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "analysis/models/laplace_likelihood.h"
#include "analysis/numerics/newton_minimum.h"

namespace analysis {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Eigen::Index;
using Eigen::VectorXd;

// Smaller standard deviations of intercepts count as 0 [logits]
constexpr double kSingularLogits = 1e-4;
// Larger standard errors, for standardised columns, count as infinite.
constexpr double kInfiniteEffect = 50.0;
constexpr double kStartingLogits[] = {1.0, 0.3};  // starting values of the standard deviations

/// The columns after the intercept, shifted and scaled to mean 0 and standard deviation 1. All
/// parameters are then of the order of one, as minimise() requires.
struct StandardisedColumns {
  explicit StandardisedColumns(const FixedEffects& fixed) {
    const auto n = static_cast<Index>(fixed.answers());
    const auto effects = static_cast<Index>(fixed.columns()) - 1;
    columns.resize(n, effects);
    for (Index j = 0; j < effects; ++j) {
      const auto values = fixed.column(static_cast<std::size_t>(j) + 1);
      columns.col(j) = VectorXd::Map(values.data(), n);
    }
    means = columns.colwise().mean();
    columns.rowwise() -= means.transpose();
    scales = (columns.colwise().squaredNorm() / static_cast<double>(n)).cwiseSqrt();
    columns = columns * scales.cwiseInverse().asDiagonal();
  }

  /// The matrix that turns parameters of the standardised columns into those of the columns
  /// themselves: β = β' / scale, θ = θ' + Σ mean β.
  Matrix backTransform(Index thresholds, Index size) const {
    Matrix matrix = Matrix::Identity(size, size);
    matrix.block(thresholds, thresholds, scales.size(), scales.size()) =
        scales.cwiseInverse().asDiagonal();
    matrix.block(0, thresholds, thresholds, scales.size()).rowwise() =
        means.cwiseQuotient(scales).transpose();
    return matrix;
  }

  Eigen::MatrixXd columns;
  VectorXd means;
  VectorXd scales;
};

struct Answers {
  std::vector<int> levels;
  std::vector<std::size_t> indices;

  explicit Answers(std::span<const int> y) {
    const std::set<int> given(y.begin(), y.end());
    levels.assign(given.begin(), given.end());
    for (const int answer : y) {
      const auto place = std::ranges::lower_bound(levels, answer);
      indices.push_back(static_cast<std::size_t>(place - levels.begin()));
    }
  }

  Index thresholds() const { return static_cast<Index>(levels.size()) - 1; }

  /// Starting values: the thresholds that reproduce the observed share of each level.
  VectorXd startingThresholds() const {
    VectorXd startingThresholds(thresholds());
    for (std::size_t c = 0; c + 1 < levels.size(); ++c) {
      const auto below = static_cast<double>(
          std::ranges::count_if(indices, [&](std::size_t index) { return index <= c; }));
      startingThresholds(static_cast<Index>(c)) =
          std::log(below / (static_cast<double>(indices.size()) - below));
    }
    return startingThresholds;
  }
};

/// Separation: a level of a factor whose answers are all the lowest or all the highest has an
/// infinite effect, and the likelihood no maximum.
Reason whySeparated(const Answers& answers, const Factor& factor) {
  for (std::size_t level = 0; level < factor.levels.size(); ++level) {
    std::set<std::size_t> given;
    for (std::size_t i = 0; i < answers.indices.size(); ++i) {
      if (factor.levelOfAnswer[i] == level) given.insert(answers.indices[i]);
    }
    const std::size_t only = *given.begin();
    if (given.size() == 1 && (only == 0 || only + 1 == answers.levels.size())) {
      const auto& name = factor.levels[level];
      return only == 0 ? reason("all_lowest", name, factor.name, answers.levels[only])
                       : reason("all_highest", name, factor.name, answers.levels[only]);
    }
  }
  return {};
}

Reason whyModelIsNotDefined(
    const Answers& answers, const FixedEffects& fixed, std::span<const Factor> random) {
  if (auto why = whyNotDefined(fixed, random); !why.empty()) return why;
  if (answers.levels.size() < 2) return reason("all_answers_same");
  for (const auto& factor : fixed.factors()) {
    if (auto why = whySeparated(answers, factor); !why.empty()) return why;
  }
  return {};
}

Minimum largestLikelihood(LaplaceLikelihood& likelihood, const VectorXd& start) {
  const Objective objective{
      .value = [&](const VectorXd& at) { return likelihood.value(at); },
      .derivatives = [&](const VectorXd& at) { return likelihood.derivatives(at); },
      // Standard deviations may become negative during the search: the likelihood is even in them.
      .lowerBound = -std::numeric_limits<double>::infinity()};
  return minimise(objective, start);
}

/// Fits without random intercepts first, and uses the result as the start of the fit with them.
/// Uses a second start if the first one fails or ends at a standard deviation of zero, which is a
/// stationary point even if it is no maximum.
std::optional<Minimum> bestFit(
    const Answers& answers, const StandardisedColumns& x, std::span<const Factor> random) {
  LaplaceLikelihood plain(answers.indices, answers.levels.size(), x.columns, {});
  VectorXd start = VectorXd::Zero(plain.parameters());
  start.head(answers.thresholds()) = answers.startingThresholds();
  const auto marginal = largestLikelihood(plain, start);
  if (!marginal.isFound) return std::nullopt;
  if (random.empty()) return marginal;

  std::optional<Minimum> best;
  const auto deviations = static_cast<Index>(random.size());
  for (const double deviation : kStartingLogits) {
    LaplaceLikelihood likelihood(answers.indices, answers.levels.size(), x.columns, random);
    start.resize(likelihood.parameters());
    start << marginal.at, VectorXd::Constant(deviations, deviation);
    auto minimum = largestLikelihood(likelihood, start);
    if (minimum.isFound && (!best || minimum.value < best->value)) best = std::move(minimum);
    if (best && !(best->at.tail(deviations).array().abs() < kSingularLogits).any()) break;
  }
  return best;
}

/// The inverse of the Hessian; std::nullopt if an effect has no finite estimate.
std::optional<Matrix> covarianceOf(const Minimum& minimum, std::size_t deviations) {
  const Matrix hessian = minimum.derivatives.hessian;
  // Without a Cholesky factor the maximum is not strict: the likelihood is flat in some direction.
  const Eigen::LLT<Matrix> cholesky(hessian);
  if (cholesky.info() != Eigen::Success) return std::nullopt;
  const Matrix covariance = cholesky.solve(Matrix::Identity(hessian.rows(), hessian.cols()));
  const auto variances =
      covariance.diagonal().head(hessian.rows() - static_cast<Index>(deviations));
  // Along an infinite estimate the likelihood flattens out, and its variance grows without end.
  if (!(variances.maxCoeff() < kInfiniteEffect * kInfiniteEffect)) return std::nullopt;
  return covariance;
}

CumulativeLinkFit fitOf(
    const Answers& answers,
    const FixedEffects& fixed,
    std::span<const Factor> random,
    const Minimum& minimum,
    const Matrix& standardisedCovariance) {
  CumulativeLinkFit fit{
      .answers = fixed.answers(),
      .levels = answers.levels,
      .thresholds = {},
      .fixedEffects = {},
      .components = {},
      .logLikelihood = -minimum.value,
      .iterations = minimum.iterations,
      .covariance = {}};
  const Index thresholds = answers.thresholds();
  const Index effects = static_cast<Index>(fixed.columns()) - 1;
  Matrix back = StandardisedColumns(fixed).backTransform(thresholds, minimum.at.size());
  for (Index k = thresholds + effects; k < minimum.at.size(); ++k) {
    if (minimum.at(k) < 0.0) back(k, k) = -1.0;  // the likelihood is even in each deviation
  }
  // Transforms the estimates and their covariance back to the original columns.
  const VectorXd at = back * minimum.at;
  const Matrix covariance = back * standardisedCovariance * back.transpose();
  for (Index c = 0; c < thresholds; ++c) {
    const auto level = fit.levels.begin() + c;
    fit.thresholds.push_back(waldEstimate(
        std::to_string(level[0]) + "|" + std::to_string(level[1]), at(c), covariance(c, c)));
  }
  for (Index j = 0; j < effects; ++j) {
    const Index place = thresholds + j;
    const auto& name = fixed.name(static_cast<std::size_t>(j) + 1);
    fit.fixedEffects.push_back(waldEstimate(name, at(place), covariance(place, place)));
  }
  fit.covariance.assign(covariance.data(), covariance.data() + covariance.size());
  for (Index k = thresholds + effects; const auto& factor : random) {
    const double deviation = at(k++);
    fit.components.push_back(
        {.name = factor.name,
         .levels = factor.levels.size(),
         .variance = deviation * deviation,
         .standardDeviation = deviation,
         .isSingular = deviation < kSingularLogits});
  }
  return fit;
}

}  // namespace

CumulativeLinkResult fitCumulativeLinkMixedModel(
    std::span<const int> y, const FixedEffects& fixed, std::span<const Factor> random) {
  if (y.size() != fixed.answers()) {
    throw std::invalid_argument("a cumulative link model needs one level for each answer");
  }
  const Answers answers(y);
  CumulativeLinkResult result;
  result.reason = whyModelIsNotDefined(answers, fixed, random);
  if (!result.reason.empty()) return result;

  const StandardisedColumns x(fixed);
  const auto minimum = bestFit(answers, x, random);
  if (!minimum) {
    result.reason = reason("no_maximum");
    return result;
  }
  const auto covariance = covarianceOf(*minimum, random.size());
  if (!covariance) {
    result.reason = reason("separated");
    return result;
  }
  result.fit = fitOf(answers, fixed, random, *minimum, *covariance);
  return result;
}

WaldEstimate contrast(
    const CumulativeLinkFit& fit, std::string name, std::span<const double> weights) {
  const std::size_t size = fit.fixedEffects.size();
  if (weights.size() != size + 1 || weights[0] != 0.0) {
    throw std::invalid_argument(
        "a contrast needs one weight for each column, and none for the intercept");
  }
  // Index of the first fixed effect in the covariance matrix.
  const std::size_t base = fit.thresholds.size();
  // w'β and w'Vw; weights[0] belongs to the intercept, which the model does not have.
  double value = 0.0;
  double variance = 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    value += weights[i + 1] * fit.fixedEffects[i].estimate;
    for (std::size_t j = 0; j < size; ++j) {
      const std::size_t place = (base + i) * fit.parameters() + base + j;
      variance += weights[i + 1] * weights[j + 1] * fit.covariance[place];
    }
  }
  return waldEstimate(std::move(name), value, variance);
}

}  // namespace analysis
