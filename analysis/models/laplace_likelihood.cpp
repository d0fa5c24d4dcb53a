#include "analysis/models/laplace_likelihood.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "analysis/models/cumulative_logit.h"

namespace analysis {
namespace {

constexpr int kMostSteps = 100;
constexpr int kMostHalvings = 40;
constexpr double kNoFallLeft = 1e-18;  // of the penalised likelihood: u is right to 1e-9, and
                                       // Newton's last step squares that
constexpr double kDifference = 5e-5;   // for the Hessian

}  // namespace

LaplaceLikelihood::LaplaceLikelihood(
    std::vector<std::size_t> y,
    std::size_t levels,
    std::vector<std::vector<double>> columns,
    std::span<const Factor> random)
    : y_(std::move(y)),
      thresholds_(levels - 1),
      columns_(std::move(columns)),
      intercepts_(random.size()),
      places_(y_.size() * random.size()) {
  std::vector<std::size_t> order(random.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(
      order, std::ranges::greater(), [&](std::size_t k) { return random[k].levels.size(); });
  for (const std::size_t k : order) {
    for (std::size_t i = 0; i < y_.size(); ++i) {
      places_[i * intercepts_ + k] = effects_ + random[k].levelOfAnswer[i];
    }
    effects_ += random[k].levels.size();
  }
  if (!order.empty()) largest_ = random[order.front()].levels.size();
  u_.assign(effects_, 0.0);
}

std::size_t LaplaceLikelihood::parameters() const noexcept {
  return thresholds_ + columns_.size() + intercepts_;
}

std::optional<double> LaplaceLikelihood::value(std::span<const double> parameters) {
  const auto mode = findMode(parameters);
  if (!mode) return std::nullopt;
  const double value = mode->penalised + 0.5 * mode->system.logDeterminant();
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<std::vector<double>> LaplaceLikelihood::gradient(std::span<const double> parameters) {
  const auto mode = findMode(parameters);
  if (!mode) return std::nullopt;
  std::vector<double> leverage;
  const auto slope = mode->system.solve(curvatureSlope(parameters, *mode, leverage));
  std::vector<double> gradient(parameters.size(), 0.0);
  for (std::size_t i = 0; i < y_.size(); ++i) {
    addAnswer(i, parameters, *mode, leverage[i], slope, gradient);
  }
  return gradient;
}

std::optional<Derivatives> LaplaceLikelihood::derivatives(std::span<const double> parameters) {
  const std::size_t size = parameters.size();
  const auto here = gradient(parameters);
  if (!here) return std::nullopt;
  Derivatives derivatives{.gradient = *here, .hessian = std::vector<double>(size * size, 0.0)};
  std::vector<double> point(parameters.begin(), parameters.end());
  for (std::size_t j = 0; j < size; ++j) {
    point[j] = parameters[j] + kDifference;
    const auto after = gradient(point);
    point[j] = parameters[j] - kDifference;
    const auto before = gradient(point);
    point[j] = parameters[j];
    if (!after || !before) return std::nullopt;
    for (std::size_t k = 0; k < size; ++k) {
      const double half = ((*after)[k] - (*before)[k]) / (4.0 * kDifference);
      derivatives.hessian[j * size + k] += half;  // the mean of both triangles
      derivatives.hessian[k * size + j] += half;
    }
  }
  return derivatives;
}

std::vector<double> LaplaceLikelihood::fixedPredictor(std::span<const double> parameters) const {
  std::vector<double> predictor(y_.size(), 0.0);
  for (std::size_t j = 0; j < columns_.size(); ++j) {
    const double beta = parameters[thresholds_ + j];
    for (std::size_t i = 0; i < y_.size(); ++i) predictor[i] += beta * columns_[j][i];
  }
  return predictor;
}

double LaplaceLikelihood::predictor(
    std::span<const double> sigma, const std::vector<double>& u, std::size_t i) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < intercepts_; ++k) sum += sigma[k] * u[places_[i * intercepts_ + k]];
  return sum;
}

double LaplaceLikelihood::above(std::span<const double> parameters, std::size_t i) const {
  return y_[i] < thresholds_ ? parameters[y_[i]] : std::numeric_limits<double>::infinity();
}

double LaplaceLikelihood::below(std::span<const double> parameters, std::size_t i) const {
  return y_[i] > 0 ? parameters[y_[i] - 1] : -std::numeric_limits<double>::infinity();
}

bool LaplaceLikelihood::isOrdered(std::span<const double> parameters) const {
  for (std::size_t c = 1; c < thresholds_; ++c) {
    if (!(parameters[c - 1] < parameters[c])) return false;
  }
  return true;
}

double LaplaceLikelihood::penalised(
    std::span<const double> parameters,
    const std::vector<double>& fixed,
    const std::vector<double>& u) const {
  const auto sigma = parameters.last(intercepts_);
  double sum = 0.5 * std::inner_product(u.begin(), u.end(), u.begin(), 0.0);
  for (std::size_t i = 0; i < y_.size(); ++i) {
    const double eta = fixed[i] + predictor(sigma, u, i);
    sum -= CumulativeLogit(above(parameters, i) - eta, below(parameters, i) - eta).logProbability;
  }
  return sum;
}

/// Fills and factorises D at u; the step is D⁻¹ times the gradient.
std::vector<double> LaplaceLikelihood::newtonStep(
    std::span<const double> parameters, Mode& mode, const std::vector<double>& u) const {
  const auto sigma = parameters.last(intercepts_);
  mode.system = ArrowMatrix(largest_, effects_ - largest_);
  std::vector<double> downhill(effects_);
  for (std::size_t m = 0; m < effects_; ++m) {
    downhill[m] = -u[m];
    mode.system.add(m, m, 1.0);
  }
  for (std::size_t i = 0; i < y_.size(); ++i) {
    const double eta = mode.predictor[i];
    const CumulativeLogit at(above(parameters, i) - eta, below(parameters, i) - eta);
    const auto* place = places_.data() + i * intercepts_;
    for (std::size_t k = 0; k < intercepts_; ++k) {
      downhill[place[k]] += sigma[k] * at.slope;
      for (std::size_t l = 0; l < intercepts_; ++l) {
        mode.system.add(place[k], place[l], at.weight * sigma[k] * sigma[l]);
      }
    }
  }
  if (!mode.system.factorise()) return {};
  auto step = mode.system.solve(downhill);
  const double fall = std::inner_product(step.begin(), step.end(), downhill.begin(), 0.0);
  if (!(fall > kNoFallLeft)) std::ranges::fill(step, 0.0);
  return step;
}

std::optional<LaplaceLikelihood::Mode> LaplaceLikelihood::findMode(
    std::span<const double> parameters) {
  if (!isOrdered(parameters)) return std::nullopt;
  const auto sigma = parameters.last(intercepts_);
  const auto fixed = fixedPredictor(parameters);
  Mode mode{.predictor = fixed, .system = ArrowMatrix(0, 0)};
  std::vector<double> u = u_;
  mode.penalised = penalised(parameters, fixed, u);
  for (int steps = 0; steps < kMostSteps && std::isfinite(mode.penalised); ++steps) {
    for (std::size_t i = 0; i < y_.size(); ++i) {
      mode.predictor[i] = fixed[i] + predictor(sigma, u, i);
    }
    const auto step = newtonStep(parameters, mode, u);
    if (step.size() != effects_) return std::nullopt;
    if (std::ranges::all_of(step, [](double move) { return move == 0.0; })) {
      u_ = u;
      return mode;
    }
    double part = 1.0;
    for (int halving = 0; halving < kMostHalvings; ++halving, part *= 0.5) {
      std::vector<double> next = u;
      for (std::size_t m = 0; m < effects_; ++m) next[m] += part * step[m];
      const double value = penalised(parameters, fixed, next);
      if (!(value <= mode.penalised * (1.0 + 1e-13))) continue;
      mode.penalised = value;
      u = std::move(next);
      break;
    }
  }
  return std::nullopt;
}

/// Half of this, times dû, is what ½ ln |D| changes by with the mode. Also gives z_iᵀD⁻¹z_i.
std::vector<double> LaplaceLikelihood::curvatureSlope(
    std::span<const double> parameters, const Mode& mode, std::vector<double>& leverage) const {
  const auto sigma = parameters.last(intercepts_);
  std::vector<double> slope(effects_, 0.0);
  leverage.assign(y_.size(), 0.0);
  for (std::size_t i = 0; i < y_.size(); ++i) {
    const auto* place = places_.data() + i * intercepts_;
    for (std::size_t k = 0; k < intercepts_; ++k) {
      for (std::size_t l = 0; l < intercepts_; ++l) {
        leverage[i] += sigma[k] * sigma[l] * mode.system.inverse(place[k], place[l]);
      }
    }
    const double eta = mode.predictor[i];
    const CumulativeLogit at(above(parameters, i) - eta, below(parameters, i) - eta);
    const double change = -(at.densitySlopeAbove + at.densitySlopeBelow) * leverage[i];
    for (std::size_t k = 0; k < intercepts_; ++k) slope[place[k]] += sigma[k] * change;
  }
  return slope;
}

void LaplaceLikelihood::addAnswer(
    std::size_t i,
    std::span<const double> parameters,
    const Mode& mode,
    double leverage,
    const std::vector<double>& slope,
    std::vector<double>& gradient) const {
  const auto sigma = parameters.last(intercepts_);
  const double eta = mode.predictor[i];
  const CumulativeLogit at(above(parameters, i) - eta, below(parameters, i) - eta);
  const double shift = predictor(sigma, slope, i);
  const auto ofThreshold = [&](double first, double density, double densitySlope) {
    return -first + 0.5 * leverage * densitySlope + 0.5 * shift * density;
  };
  if (y_[i] < thresholds_) {
    gradient[y_[i]] += ofThreshold(at.slopeAbove, at.densityAbove, at.densitySlopeAbove);
  }
  if (y_[i] > 0) {
    gradient[y_[i] - 1] += ofThreshold(at.slopeBelow, at.densityBelow, at.densitySlopeBelow);
  }
  const double ofPredictor = -at.slope - 0.5 * shift * at.weight -
                             0.5 * leverage * (at.densitySlopeAbove + at.densitySlopeBelow);
  for (std::size_t j = 0; j < columns_.size(); ++j) {
    gradient[thresholds_ + j] += columns_[j][i] * ofPredictor;
  }
  const auto* place = places_.data() + i * intercepts_;
  for (std::size_t k = 0; k < intercepts_; ++k) {
    double row = 0.0;  // of D⁻¹ z
    for (std::size_t l = 0; l < intercepts_; ++l) {
      row += sigma[l] * mode.system.inverse(place[k], place[l]);
    }
    gradient[thresholds_ + columns_.size() + k] +=
        u_[place[k]] * ofPredictor + at.weight * row + 0.5 * slope[place[k]] * at.slope;
  }
}

}  // namespace analysis
