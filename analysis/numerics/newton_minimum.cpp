#include "analysis/numerics/newton_minimum.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>

namespace analysis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int kMostIterations = 200;
constexpr int kMostHalvings = 40;
constexpr int kLastSteps = 3;  // each step of Newton's method doubles the number of digits
// The minimised likelihoods have parameters of the order of one.
constexpr double kLongestStep = 2.0;
// Least decrease of the function, relative to the decrease that the gradient predicts (Armijo).
constexpr double kSufficientDecrease = 1e-4;
// Relative to the largest curvature; a direction of less curvature is flat.
constexpr double kSmallestCurvature = 1e-10;
constexpr double kNearMinimum = 1e-8;  // predicted decrease of a step, relative to the value

struct Step {
  VectorXd move;
  double predictedDecrease = 0.0;  ///< −gᵀ move; near the minimum, twice the decrease
  bool isConvex = true;
};

/// The Newton step. A parameter at the bound is kept fixed if the function falls beyond the bound.
Step newtonStep(const VectorXd& at, const Derivatives& derivatives, double lowerBound) {
  std::vector<Index> free;
  for (Index i = 0; i < at.size(); ++i) {
    if (at(i) > lowerBound || derivatives.gradient(i) < 0.0) free.push_back(i);
  }
  Step step{.move = VectorXd::Zero(at.size())};
  if (free.empty()) return step;

  const VectorXd gradient = derivatives.gradient(free);
  const Eigen::MatrixXd hessian = derivatives.hessian(free, free);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(hessian);
  const VectorXd& values = eigen.eigenvalues();
  const double largest = std::max(values.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
  step.isConvex = values.minCoeff() > kSmallestCurvature * largest;

  // Absolute values turn an ascent along a direction of negative curvature into a descent.
  const VectorXd curvature = values.cwiseAbs().cwiseMax(kSmallestCurvature * largest);
  const VectorXd along = eigen.eigenvectors().transpose() * gradient;
  VectorXd move = -eigen.eigenvectors() * along.cwiseQuotient(curvature);
  step.predictedDecrease = -gradient.dot(move);
  move *= std::min(1.0, kLongestStep / move.cwiseAbs().maxCoeff());
  if (move.allFinite()) step.move(free) = move;
  return step;
}

/// Moves along the step, halving it until the function decreases; false if it never does.
bool descend(const Objective& objective, const Step& step, Minimum& minimum) {
  double part = 1.0;
  for (int halving = 0; halving < kMostHalvings; ++halving, part *= 0.5) {
    VectorXd point = (minimum.at + part * step.move).cwiseMax(objective.lowerBound);
    const auto value = objective.value(point);
    // Uses the projected step, which the bound may have shortened.
    const double requiredDecrease =
        kSufficientDecrease * minimum.derivatives.gradient.dot(minimum.at - point);
    if (!value || !(*value <= minimum.value - requiredDecrease) || !(requiredDecrease > 0.0))
      continue;
    minimum.at = std::move(point);
    minimum.value = *value;
    return true;
  }
  return false;
}

/// Very near the minimum the value has too few digits to show a decrease. Newton's step, computed
/// from the gradient, is still accurate.
bool takeLastStep(const Objective& objective, const Step& step, Minimum& minimum) {
  VectorXd point = (minimum.at + step.move).cwiseMax(objective.lowerBound);
  const auto value = objective.value(point);
  if (!value || *value > minimum.value + kNearMinimum * (1.0 + std::abs(minimum.value)))
    return false;
  minimum.at = std::move(point);
  minimum.value = *value;
  return true;
}

}  // namespace

Minimum minimise(const Objective& objective, VectorXd start) {
  Minimum minimum{.at = std::move(start)};
  const auto value = objective.value(minimum.at);
  if (!value) return minimum;

  minimum.value = *value;
  int lastSteps = 0;
  for (; minimum.iterations < kMostIterations; ++minimum.iterations) {
    const auto derivatives = objective.derivatives(minimum.at);
    if (!derivatives) return minimum;
    minimum.derivatives = *derivatives;

    const Step step = newtonStep(minimum.at, *derivatives, objective.lowerBound);
    const bool isNear =
        step.predictedDecrease <= kNearMinimum * (1.0 + std::abs(minimum.value)) && step.isConvex;
    if (isNear && (lastSteps++ == kLastSteps || !takeLastStep(objective, step, minimum))) {
      minimum.isFound = true;
      return minimum;
    }
    if (!isNear && !descend(objective, step, minimum)) return minimum;
  }
  return minimum;
}

}  // namespace analysis
