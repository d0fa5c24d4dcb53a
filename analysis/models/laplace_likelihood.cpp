#include "analysis/models/laplace_likelihood.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace analysis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int kMostSteps = 100;
constexpr int kMostHalvings = 40;
// A Newton step that would decrease the penalised likelihood by less is not taken: u then has an
// error of about 1e-9.
constexpr double kNegligibleDecrease = 1e-18;
constexpr double kRounding = 1e-13;  // relative rounding error of a sum of logarithms
// Step of the central differences for the Hessian. Their truncation error, about the square of the
// step, is then about as large as the rounding error, 1e-14 divided by the step.
constexpr double kDifferenceStep = 5e-5;

/// ln F(x), without overflow.
double logLogistic(double x) {
  return x > 0.0 ? -std::log1p(std::exp(-x)) : x - std::log1p(std::exp(x));
}

/// The member @p number of each of the @p answers, as a vector.
VectorXd memberOfEach(
    const std::vector<CumulativeLogit>& answers, double CumulativeLogit::*number) {
  VectorXd numbers(static_cast<Index>(answers.size()));
  for (Index i = 0; const auto& answer : answers) numbers(i++) = answer.*number;
  return numbers;
}

double penalisedNegativeLog(const std::vector<CumulativeLogit>& answers, const VectorXd& u) {
  return 0.5 * u.squaredNorm() - memberOfEach(answers, &CumulativeLogit::logProbability).sum();
}

}  // namespace

double logistic(double x) {
  if (x > 0.0) return 1.0 / (1.0 + std::exp(-x));
  const double power = std::exp(x);
  return power / (1.0 + power);
}

CumulativeLogit::CumulativeLogit(double above, double below) {
  const double overA = logistic(-above);  // 1 − F(a)
  const double underB = logistic(below);  // F(b)
  densityAbove = overA * logistic(above);
  densityBelow = underB * logistic(-below);
  densitySlopeAbove = densityAbove * (2.0 * overA - 1.0);
  densitySlopeBelow = densityBelow * (1.0 - 2.0 * underB);
  slope = underB - overA;
  weight = densityAbove + densityBelow;

  const bool isBetween = std::isfinite(above) && std::isfinite(below);
  const double gap = isBetween ? std::expm1(above - below) : HUGE_VAL;  // e^{a−b} − 1
  slopeAbove = overA + 1.0 / gap;
  slopeBelow = -underB - 1.0 / gap;
  logProbability = (std::isfinite(above) ? logLogistic(above) : 0.0) +
                   (std::isfinite(below) ? logLogistic(-below) : 0.0) +
                   (isBetween ? std::log(-std::expm1(below - above)) : 0.0);
}

LaplaceLikelihood::LaplaceLikelihood(
    std::vector<std::size_t> y,
    std::size_t levels,
    Eigen::MatrixXd x,
    std::span<const Factor> random)
    : y_(std::move(y)), thresholds_(levels - 1), x_(std::move(x)) {
  Index effects = 0;
  for (const auto& factor : random) effects += static_cast<Index>(factor.levels.size());
  Index from = 0;
  for (const auto& factor : random) {
    std::vector<Eigen::Triplet<double>> places;
    for (Index i = 0; const std::size_t level : factor.levelOfAnswer) {
      places.emplace_back(from + static_cast<Index>(level), i++, 1.0);
    }
    indicators_.emplace_back(effects, x_.rows()).setFromTriplets(places.begin(), places.end());
    from += static_cast<Index>(factor.levels.size());
  }
  u_ = VectorXd::Zero(effects);
}

Index LaplaceLikelihood::parameters() const noexcept {
  return static_cast<Index>(thresholds_ + indicators_.size()) + x_.cols();
}

std::optional<double> LaplaceLikelihood::value(const VectorXd& parameters) {
  const auto mode = findMode(parameters);
  if (!mode) return std::nullopt;
  double value = mode->penalisedNegativeLog;
  if (u_.size() > 0) {
    value += system_.matrixL().nestedExpression().diagonal().array().log().sum();  // ½ ln |D|
  }
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// With D⁻¹ = RᵀR, A = RZ and A_k = RZ_k of one intercept, h_i = z_iᵀD⁻¹z_i is the square of A's
/// column i, and z_ikᵀD⁻¹z_i its product with that of A_k. The derivative of the value by w_i is ½
/// h_i. The value also changes with the mode, which moves by D⁻¹ times the change of its gradient.
std::optional<VectorXd> LaplaceLikelihood::gradient(const VectorXd& parameters) {
  const auto mode = findMode(parameters);
  if (!mode) return std::nullopt;
  const auto memberVector = [&](double CumulativeLogit::*number) {
    return memberOfEach(mode->answers, number);
  };
  const VectorXd slope = memberVector(&CumulativeLogit::slope);
  const VectorXd weight = memberVector(&CumulativeLogit::weight);
  const VectorXd weightSlope = -memberVector(&CumulativeLogit::densitySlopeAbove) -
                               memberVector(&CumulativeLogit::densitySlopeBelow);

  const Sparse root = rootOfInverse();
  const Sparse half = root * mode->z;  // A
  const VectorXd leverage = half.cwiseProduct(half).transpose() * VectorXd::Ones(u_.size());
  // D⁻¹ times the gradient of ln |D| in u: twice the movement of the mode.
  const VectorXd twiceModeShift =
      root.transpose() * (root * (mode->z * weightSlope.cwiseProduct(leverage)));
  const VectorXd shift = mode->z.transpose() * twiceModeShift;
  const VectorXd ofPredictor =
      0.5 * leverage.cwiseProduct(weightSlope) - slope - 0.5 * shift.cwiseProduct(weight);

  VectorXd gradient = VectorXd::Zero(parameters.size());
  for (std::size_t i = 0; i < y_.size(); ++i) {
    const auto row = static_cast<Index>(i);
    const auto& at = mode->answers[i];
    const auto thresholdDerivative = [&](double first, double density, double densitySlope) {
      return -first + 0.5 * leverage(row) * densitySlope + 0.5 * shift(row) * density;
    };
    const auto above = static_cast<Index>(y_[i]);
    if (y_[i] < thresholds_) {
      gradient(above) += thresholdDerivative(at.slopeAbove, at.densityAbove, at.densitySlopeAbove);
    }
    if (y_[i] > 0) {
      gradient(above - 1) +=
          thresholdDerivative(at.slopeBelow, at.densityBelow, at.densitySlopeBelow);
    }
  }
  const auto first = static_cast<Index>(thresholds_);
  gradient.segment(first, x_.cols()) = x_.transpose() * ofPredictor;
  for (Index k = first + x_.cols(); const auto& indicator : indicators_) {
    gradient(k++) = mode->u.dot(indicator * ofPredictor) +
                    0.5 * twiceModeShift.dot(indicator * slope) +
                    (Sparse(root * indicator).cwiseProduct(half) * weight).sum();
  }
  return gradient;
}

std::optional<Derivatives> LaplaceLikelihood::derivatives(const VectorXd& parameters) {
  const Index size = parameters.size();
  const auto here = gradient(parameters);
  if (!here) return std::nullopt;
  Derivatives derivatives{.gradient = *here, .hessian = Eigen::MatrixXd(size, size)};
  for (Index j = 0; j < size; ++j) {
    const VectorXd step = kDifferenceStep * VectorXd::Unit(size, j);
    const auto after = gradient(parameters + step);
    const auto before = gradient(parameters - step);
    if (!after || !before) return std::nullopt;
    derivatives.hessian.col(j) = (*after - *before) / (2.0 * kDifferenceStep);
  }
  derivatives.hessian = 0.5 * (derivatives.hessian + derivatives.hessian.transpose()).eval();
  return derivatives;
}

LaplaceLikelihood::Sparse LaplaceLikelihood::effectsOfAnswers(const VectorXd& parameters) const {
  Sparse z(u_.size(), x_.rows());
  for (Index k = parameters.size() - static_cast<Index>(indicators_.size());
       const auto& indicator : indicators_) {
    z += parameters(k++) * indicator;
  }
  return z;
}

std::vector<CumulativeLogit> LaplaceLikelihood::answersAt(
    const VectorXd& parameters, const VectorXd& predictor) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<CumulativeLogit> answers;
  answers.reserve(y_.size());
  for (Index i = 0; const std::size_t y : y_) {
    const auto level = static_cast<Index>(y);
    const double above = y < thresholds_ ? parameters(level) : kInfinity;
    const double below = y > 0 ? parameters(level - 1) : -kInfinity;
    answers.emplace_back(above - predictor(i), below - predictor(i));
    ++i;
  }
  return answers;
}

/// Factorises D. Returns D⁻¹ times the gradient, or zero if that step would not decrease the
/// function.
VectorXd LaplaceLikelihood::newtonStep(const Mode& mode) {
  if (u_.size() == 0) return u_;
  const VectorXd weight = memberOfEach(mode.answers, &CumulativeLogit::weight);
  Sparse d(u_.size(), u_.size());
  d.setIdentity();
  d += Sparse(mode.z * weight.asDiagonal() * mode.z.transpose());
  system_.compute(d);
  const VectorXd downhill = mode.z * memberOfEach(mode.answers, &CumulativeLogit::slope) - mode.u;
  const VectorXd step = system_.solve(downhill);
  return step.dot(downhill) > kNegligibleDecrease ? step : VectorXd::Zero(u_.size());
}

std::optional<LaplaceLikelihood::Mode> LaplaceLikelihood::findMode(const VectorXd& parameters) {
  const double* const last = parameters.data() + thresholds_;
  if (std::adjacent_find(parameters.data(), last, std::greater_equal()) != last) {
    return std::nullopt;
  }
  const auto first = static_cast<Index>(thresholds_);
  const VectorXd fixed = x_ * parameters.segment(first, x_.cols());
  Mode mode{.z = effectsOfAnswers(parameters), .u = u_, .answers = {}};
  mode.answers = answersAt(parameters, fixed + mode.z.transpose() * mode.u);
  mode.penalisedNegativeLog = penalisedNegativeLog(mode.answers, mode.u);
  for (int steps = 0; steps < kMostSteps && std::isfinite(mode.penalisedNegativeLog); ++steps) {
    const VectorXd step = newtonStep(mode);
    if (step.isZero(0.0)) {
      u_ = mode.u;
      return mode;
    }
    double part = 1.0;
    for (int halving = 0; halving < kMostHalvings; ++halving, part *= 0.5) {
      const VectorXd u = mode.u + part * step;
      auto answers = answersAt(parameters, fixed + mode.z.transpose() * u);
      const double value = penalisedNegativeLog(answers, u);
      if (!(value <= mode.penalisedNegativeLog * (1.0 + kRounding))) continue;
      mode.penalisedNegativeLog = value;
      mode.u = u;
      mode.answers = std::move(answers);
      break;
    }
  }
  return std::nullopt;
}

LaplaceLikelihood::Sparse LaplaceLikelihood::rootOfInverse() const {
  Sparse root(u_.size(), u_.size());
  if (u_.size() == 0) return root;
  root.setIdentity();
  root = system_.permutationP() * root;
  system_.matrixL().solveInPlace(root);
  return root;
}

}  // namespace analysis
