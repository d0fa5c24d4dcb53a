#include "analysis/models/answer_probability.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Core>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "analysis/models/laplace_likelihood.h"

namespace analysis {
namespace {

using Eigen::Index;

/// The expectation of f(u) for a standard normal u.
template <typename Function>
double normalMean(Function f) {
  using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
  constexpr double kLargestDeviate = 9.0;  // |u| > 9 has a probability of 2e-19
  constexpr unsigned kHalvings = 15;
  constexpr double kError = 1e-13;
  const auto weighted = [&](double u) {
    return f(u) * std::exp(-0.5 * u * u) * boost::math::constants::one_div_root_two_pi<double>();
  };
  return Rule::integrate(weighted, -kLargestDeviate, kLargestDeviate, kHalvings, kError);
}

/// The probability for one row of the design matrix, and its derivatives.
struct MarginalPart {
  double probability = 0.0;
  double predictorDerivative = 0.0;
  double deviationDerivative = 0.0;
};

MarginalPart marginalPartOf(double predictor, double deviation) {
  const auto at = [&](double u) { return predictor + deviation * u; };
  const auto slope = [&](double u) { return logistic(at(u)) * logistic(-at(u)); };
  return {
      .probability = normalMean([&](double u) { return logistic(at(u)); }),
      .predictorDerivative = normalMean(slope),
      .deviationDerivative = normalMean([&](double u) { return u * slope(u); })};
}

/// The standard deviation of the sum of all random intercepts [logits].
double deviationOf(const CumulativeLinkFit& fit) {
  double variance = 0.0;
  for (const auto& component : fit.components) variance += component.variance;
  return std::sqrt(variance);
}

/// x'β without the intercept, which the thresholds include.
double effectOf(const CumulativeLinkFit& fit, const std::vector<double>& design) {
  if (design.size() != fit.fixedEffects.size() + 1) {
    throw std::invalid_argument("a design has one number for each column of the model");
  }
  double effect = 0.0;
  for (std::size_t j = 0; j < fit.fixedEffects.size(); ++j) {
    effect += design[j + 1] * fit.fixedEffects[j].estimate;
  }
  return effect;
}

/// P and its gradient with respect to the parameters, in the order of the fit's covariance.
class MarginalProbability {
 public:
  MarginalProbability(const CumulativeLinkFit& fit, std::size_t threshold)
      : fit_(fit), threshold_(threshold), deviation_(deviationOf(fit)) {
    gradient_.setZero(fit.parameters());
  }

  void add(const std::vector<double>& design, double weight) {
    const double predictor = effectOf(fit_, design) - fit_.thresholds[threshold_].estimate;
    const auto part = marginalPartOf(predictor, deviation_);
    probability_ += weight * part.probability;
    auto place = static_cast<Index>(fit_.thresholds.size());
    gradient_(static_cast<Index>(threshold_)) -= weight * part.predictorDerivative;
    for (std::size_t j = 1; j < design.size(); ++j) {
      gradient_(place++) += weight * part.predictorDerivative * design[j];
    }
    for (const auto& component : fit_.components) {
      // At σ = 0 the derivative is zero, since P is even in every σ_k.
      const double share = deviation_ > 0.0 ? component.standardDeviation / deviation_ : 0.0;
      gradient_(place++) += weight * part.deviationDerivative * share;
    }
  }

  AnswerProbability result() const {
    const auto size = gradient_.size();
    // The matrix is symmetric, so its storage order does not matter.
    const auto covariance = Eigen::Map<const Eigen::MatrixXd>(fit_.covariance.data(), size, size);
    const double variance = gradient_.dot(covariance * gradient_);
    const double slope = probability_ * (1.0 - probability_);  // dP / d logit
    const double logit = std::log(probability_) - std::log1p(-probability_);
    return {
        .probability = probability_,
        .logit = waldEstimate("logit", logit, variance / (slope * slope))};
  }

 private:
  const CumulativeLinkFit& fit_;
  std::size_t threshold_;
  double deviation_;
  double probability_ = 0.0;
  Eigen::VectorXd gradient_;
};

}  // namespace

std::optional<AnswerProbability> answerProbability(
    const CumulativeLinkFit& fit, int level, std::span<const std::vector<double>> designs) {
  if (designs.empty()) throw std::invalid_argument("a probability needs a design");
  const auto firstLevel = std::ranges::lower_bound(fit.levels, level);
  if (firstLevel == fit.levels.begin() || firstLevel == fit.levels.end()) return std::nullopt;
  MarginalProbability marginal(fit, static_cast<std::size_t>(firstLevel - fit.levels.begin()) - 1);
  for (const auto& design : designs)
    marginal.add(design, 1.0 / static_cast<double>(designs.size()));
  return marginal.result();
}

Interval probabilityInterval(const AnswerProbability& probability, double level) {
  const auto logits = confidenceInterval(probability.logit, level);
  return {logistic(logits.low), logistic(logits.high)};
}

}  // namespace analysis
