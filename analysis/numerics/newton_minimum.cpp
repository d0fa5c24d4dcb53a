#include "analysis/numerics/newton_minimum.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

namespace analysis {
namespace {

constexpr int kMostIterations = 200;
constexpr int kMostHalvings = 40;
constexpr int kLastSteps = 3;  // Newton doubles the digits with each
constexpr double kLongestStep = 2.0;
constexpr double kSufficientFall = 1e-4;
constexpr double kSmallestCurvature = 1e-10;  // of the largest
constexpr double kNear = 1e-8;                // what a step still promises, of the value

using Indices = std::vector<std::size_t>;

struct Step {
  std::vector<double> to;
  double promise = 0.0;  ///< −gᵀ step: twice what the function falls by near the minimum
  bool isConvex = true;
};

/// Parameters that the gradient does not push against the bound.
Indices freeParameters(
    const std::vector<double>& at, const std::vector<double>& gradient, double lowerBound) {
  Indices free;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (at[i] > lowerBound || gradient[i] < 0.0) free.push_back(i);
  }
  return free;
}

Step newtonStep(
    const std::vector<double>& at, const Derivatives& derivatives, const Indices& free) {
  Step step{.to = at};
  const auto size = static_cast<Eigen::Index>(free.size());
  if (size == 0) return step;

  Eigen::VectorXd gradient(size);
  Eigen::MatrixXd hessian(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const std::size_t row = free[static_cast<std::size_t>(i)];
    gradient(i) = derivatives.gradient[row];
    for (Eigen::Index j = 0; j < size; ++j) {
      hessian(i, j) = derivatives.hessian[row * at.size() + free[static_cast<std::size_t>(j)]];
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(hessian);
  const Eigen::VectorXd& values = eigen.eigenvalues();
  const double largest = std::max(values.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
  step.isConvex = values.minCoeff() > kSmallestCurvature * largest;

  const Eigen::VectorXd curvature = values.cwiseAbs().cwiseMax(kSmallestCurvature * largest);
  const Eigen::MatrixXd& vectors = eigen.eigenvectors();
  Eigen::VectorXd move =
      -vectors * (vectors.transpose() * gradient).cwiseQuotient(curvature).eval();
  step.promise = -gradient.dot(move);
  move *= std::min(1.0, kLongestStep / move.cwiseAbs().maxCoeff());
  if (!move.allFinite()) move.setZero();
  for (std::size_t i = 0; i < free.size(); ++i) {
    step.to[free[i]] += move(static_cast<Eigen::Index>(i));
  }
  return step;
}

std::vector<double> partOfTheWay(
    const std::vector<double>& from, const std::vector<double>& to, double part, double bound) {
  std::vector<double> point(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    point[i] = std::max(bound, from[i] + part * (to[i] - from[i]));
  }
  return point;
}

double fallAlong(
    const std::vector<double>& from, const std::vector<double>& to, const Derivatives& d) {
  double fall = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) fall += d.gradient[i] * (from[i] - to[i]);
  return fall;
}

/// Goes as far along the step as the function falls; false where it does not.
bool descend(const Objective& objective, const Step& step, Minimum& minimum) {
  double part = 1.0;
  for (int halving = 0; halving < kMostHalvings; ++halving, part *= 0.5) {
    auto point = partOfTheWay(minimum.at, step.to, part, objective.lowerBound);
    const auto value = objective.value(point);
    const double wanted = kSufficientFall * fallAlong(minimum.at, point, minimum.derivatives);
    if (!value || !(*value <= minimum.value - wanted) || !(wanted > 0.0)) continue;
    minimum.at = std::move(point);
    minimum.value = *value;
    return true;
  }
  return false;
}

/// So near to the minimum the function is too coarse to tell which way is down; Newton's step is
/// not.
bool takeLastStep(const Objective& objective, const Step& step, Minimum& minimum) {
  auto point = partOfTheWay(minimum.at, step.to, 1.0, objective.lowerBound);
  const auto value = objective.value(point);
  if (!value || *value > minimum.value + kNear * (1.0 + std::abs(minimum.value))) return false;
  minimum.at = std::move(point);
  minimum.value = *value;
  return true;
}

}  // namespace

Minimum minimise(const Objective& objective, std::vector<double> start) {
  Minimum minimum{.at = std::move(start)};
  const auto value = objective.value(minimum.at);
  if (!value) return minimum;

  minimum.value = *value;
  int lastSteps = 0;
  for (; minimum.iterations < kMostIterations; ++minimum.iterations) {
    const auto derivatives = objective.derivatives(minimum.at);
    if (!derivatives) return minimum;
    minimum.derivatives = *derivatives;

    const auto free = freeParameters(minimum.at, derivatives->gradient, objective.lowerBound);
    const Step step = newtonStep(minimum.at, *derivatives, free);
    const bool isNear = step.promise <= kNear * (1.0 + std::abs(minimum.value)) && step.isConvex;
    if (isNear && (lastSteps++ == kLastSteps || !takeLastStep(objective, step, minimum))) {
      minimum.isFound = true;
      return minimum;
    }
    if (!isNear && !descend(objective, step, minimum)) return minimum;
  }
  return minimum;
}

}  // namespace analysis
