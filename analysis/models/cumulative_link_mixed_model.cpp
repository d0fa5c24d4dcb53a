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
#include "analysis/models/mixed_model_design.h"
#include "analysis/numerics/newton_minimum.h"

namespace analysis {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double kSingularLogits = 1e-4;  // standard deviation [logits]
constexpr double kInfiniteEffect = 50.0;  // standard error of an effect of standardised columns
constexpr double kStartingLogits[] = {1.0, 0.3};

/// The columns after the intercept, shifted and scaled to mean 0 and standard deviation 1.
struct Standardised {
  explicit Standardised(const FixedEffects& fixed) {
    const auto n = static_cast<double>(fixed.answers());
    for (std::size_t j = 1; j < fixed.columns(); ++j) {
      const auto values = fixed.column(j);
      double mean = 0.0;
      double square = 0.0;
      for (const double value : values) mean += value / n;
      for (const double value : values) square += (value - mean) * (value - mean) / n;
      const double scale = std::sqrt(square);
      means.push_back(mean);
      scales.push_back(scale);
      columns.emplace_back();
      for (const double value : values) columns.back().push_back((value - mean) / scale);
    }
  }

  /// The matrix that turns parameters of the standardised columns into those of the columns
  /// themselves: β = β' / scale, θ = θ' + Σ mean β.
  Matrix backTransform(std::size_t thresholds, std::size_t size) const {
    const auto side = static_cast<Eigen::Index>(size);
    Matrix matrix = Matrix::Identity(side, side);
    for (std::size_t j = 0; j < scales.size(); ++j) {
      const auto place = static_cast<Eigen::Index>(thresholds + j);
      matrix(place, place) = 1.0 / scales[j];
      matrix.col(place)
          .head(static_cast<Eigen::Index>(thresholds))
          .setConstant(means[j] / scales[j]);
    }
    return matrix;
  }

  std::vector<std::vector<double>> columns;
  std::vector<double> means;
  std::vector<double> scales;
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

  /// Thresholds that give each level its share.
  std::vector<double> logits() const {
    std::vector<double> thresholds;
    for (std::size_t c = 0; c + 1 < levels.size(); ++c) {
      const auto below = static_cast<double>(
          std::ranges::count_if(indices, [&](std::size_t index) { return index <= c; }));
      thresholds.push_back(std::log(below / (static_cast<double>(indices.size()) - below)));
    }
    return thresholds;
  }
};

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

Reason whyNotDefinedHere(
    const Answers& answers, const FixedEffects& fixed, std::span<const Factor> random) {
  if (auto why = whyNotDefined(fixed, random); !why.empty()) return why;
  if (answers.levels.size() < 2) return reason("all_answers_same");
  for (const auto& factor : fixed.factors()) {
    if (auto why = whySeparated(answers, factor); !why.empty()) return why;
  }
  return {};
}

Minimum largestLikelihood(LaplaceLikelihood& likelihood, std::vector<double> start) {
  const Objective objective{
      .value = [&](auto at) { return likelihood.value(at); },
      .derivatives = [&](auto at) { return likelihood.derivatives(at); },
      .lowerBound = -std::numeric_limits<double>::infinity()};
  return minimise(objective, std::move(start));
}

bool hasSingular(const Minimum& minimum, std::size_t deviations) {
  return std::any_of(
      minimum.at.end() - static_cast<std::ptrdiff_t>(deviations),
      minimum.at.end(),
      [](double deviation) { return std::abs(deviation) < kSingularLogits; });
}

/// Without random intercepts first; from there with them, again from a second start where the
/// first found nothing or a deviation of zero.
std::optional<Minimum> bestFit(
    const Answers& answers, const Standardised& x, std::span<const Factor> random) {
  LaplaceLikelihood plain(answers.indices, answers.levels.size(), x.columns, {});
  std::vector<double> start = answers.logits();
  start.resize(plain.parameters(), 0.0);
  const auto marginal = largestLikelihood(plain, start);
  if (!marginal.isFound) return std::nullopt;
  if (random.empty()) return marginal;

  std::optional<Minimum> best;
  for (const double deviation : kStartingLogits) {
    LaplaceLikelihood likelihood(answers.indices, answers.levels.size(), x.columns, random);
    start = marginal.at;
    start.resize(likelihood.parameters(), deviation);
    auto minimum = largestLikelihood(likelihood, start);
    if (minimum.isFound && (!best || minimum.value < best->value)) best = std::move(minimum);
    if (best && !hasSingular(*best, random.size())) break;
  }
  return best;
}

/// The inverse of the Hessian; nothing where an effect has no finite estimate.
std::optional<Matrix> covarianceOf(const Minimum& minimum, std::size_t deviations) {
  const auto side = static_cast<Eigen::Index>(minimum.at.size());
  const Matrix hessian = Eigen::Map<const Matrix>(minimum.derivatives.hessian.data(), side, side);
  const Eigen::LLT<Matrix> cholesky(hessian);
  if (cholesky.info() != Eigen::Success) return std::nullopt;
  const Matrix covariance = cholesky.solve(Matrix::Identity(side, side));
  const auto variances = covariance.diagonal().head(side - static_cast<Eigen::Index>(deviations));
  if (!(variances.maxCoeff() < kInfiniteEffect * kInfiniteEffect)) return std::nullopt;
  return covariance;
}

void addEstimates(
    CumulativeLinkFit& fit,
    const FixedEffects& fixed,
    const Eigen::VectorXd& parameters,
    const Matrix& covariance) {
  const auto thresholds = static_cast<Eigen::Index>(fit.levels.size()) - 1;
  const auto effects = static_cast<Eigen::Index>(fixed.columns()) - 1;
  for (Eigen::Index c = 0; c < thresholds; ++c) {
    const auto level = static_cast<std::size_t>(c);
    fit.thresholds.push_back(waldEstimate(
        std::to_string(fit.levels[level]) + "|" + std::to_string(fit.levels[level + 1]),
        parameters(c),
        covariance(c, c)));
  }
  for (Eigen::Index j = 0; j < effects; ++j) {
    const Eigen::Index place = thresholds + j;
    fit.fixedEffects.push_back(waldEstimate(
        fixed.name(static_cast<std::size_t>(j) + 1), parameters(place), covariance(place, place)));
  }
  const Matrix ofEffects = covariance.block(thresholds, thresholds, effects, effects);
  fit.covariance.assign(ofEffects.data(), ofEffects.data() + ofEffects.size());
}

CumulativeLinkFit fitOf(
    const Answers& answers,
    const FixedEffects& fixed,
    std::span<const Factor> random,
    const Minimum& minimum,
    const Matrix& covariance) {
  CumulativeLinkFit fit{
      .answers = fixed.answers(),
      .levels = answers.levels,
      .thresholds = {},
      .fixedEffects = {},
      .components = {},
      .logLikelihood = -minimum.value,
      .iterations = minimum.iterations,
      .covariance = {}};
  const Matrix back =
      Standardised(fixed).backTransform(answers.levels.size() - 1, minimum.at.size());
  const Eigen::Map<const Eigen::VectorXd> at(
      minimum.at.data(), static_cast<Eigen::Index>(minimum.at.size()));
  addEstimates(fit, fixed, back * at, back * covariance * back.transpose());
  for (std::size_t k = 0; k < random.size(); ++k) {
    const double deviation = std::abs(minimum.at[minimum.at.size() - random.size() + k]);
    fit.components.push_back(
        {.name = random[k].name,
         .levels = random[k].levels.size(),
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
  result.reason = whyNotDefinedHere(answers, fixed, random);
  if (!result.reason.empty()) return result;

  const Standardised x(fixed);
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
  double value = 0.0;
  double variance = 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    value += weights[i + 1] * fit.fixedEffects[i].estimate;
    for (std::size_t j = 0; j < size; ++j) {
      variance += weights[i + 1] * weights[j + 1] * fit.covariance[i * size + j];
    }
  }
  return waldEstimate(std::move(name), value, variance);
}

std::vector<WaldEstimate> pairwiseDifferences(
    const CumulativeLinkFit& fit, const FixedEffects& fixed, std::string_view factor) {
  std::vector<WaldEstimate> differences;
  const auto& levels = fixed.factor(factor).levels;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    for (std::size_t j = i + 1; j < levels.size(); ++j) {
      const auto weights = fixed.difference(factor, levels[i], levels[j]);
      differences.push_back(contrast(fit, levels[i] + " - " + levels[j], weights));
    }
  }
  return differences;
}

}  // namespace analysis
