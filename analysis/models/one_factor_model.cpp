#include "analysis/models/one_factor_model.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace analysis {
namespace {

using Correlations = std::span<const std::vector<double>>;
using Loadings = std::vector<double>;

void check(Correlations correlations) {
  constexpr std::size_t kFewest = 3;
  if (correlations.size() < kFewest) {
    throw std::invalid_argument("one factor needs three items to be determined");
  }
  const auto isCorrelation = [](double r) { return r >= -1.0 && r <= 1.0; };
  for (const auto& row : correlations) {
    if (row.size() != correlations.size() || !std::ranges::all_of(row, isCorrelation)) {
      throw std::invalid_argument("a matrix of correlations is square, with entries in -1 ... 1");
    }
  }
}

double product(const Loadings& a, const Loadings& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// The first principal component, by power iteration: where to start.
Loadings principalComponent(Correlations correlations) {
  constexpr int kSteps = 200;
  Loadings component(correlations.size());
  for (std::size_t i = 0; i < component.size(); ++i) {
    // Slightly uneven: a constant vector may be orthogonal to the component that is sought.
    component[i] = 1.0 + 0.01 * static_cast<double>(i);
  }
  double length = 0.0;
  for (int step = 0; step < kSteps; ++step) {
    Loadings next;
    for (const auto& row : correlations) next.push_back(product(row, component));
    length = std::sqrt(product(next, next));
    if (length == 0.0) break;
    for (double& entry : next) entry /= length;
    component = std::move(next);
  }
  for (double& entry : component) entry = std::clamp(entry * std::sqrt(length), -1.0, 1.0);
  return component;
}

/// The best value of one loading, the others being as they are.
double bestLoading(Correlations correlations, const Loadings& loadings, std::size_t i) {
  const double squares = product(loadings, loadings) - loadings[i] * loadings[i];
  if (!(squares > 0.0)) return loadings[i];
  const double explained = product(correlations[i], loadings) - correlations[i][i] * loadings[i];
  return std::clamp(explained / squares, -1.0, 1.0);
}

}  // namespace

OneFactorModel fitOneFactor(std::span<const std::vector<double>> correlations) {
  constexpr int kMostSweeps = 100'000;
  constexpr double kStill = 4e-15;  // of a loading: some units of its last digit
  check(correlations);

  OneFactorModel model;
  model.loadings = principalComponent(correlations);
  model.hasConverged = false;
  for (int sweep = 0; sweep < kMostSweeps && !model.hasConverged; ++sweep) {
    double largestStep = 0.0;
    for (std::size_t i = 0; i < model.loadings.size(); ++i) {
      const double best = bestLoading(correlations, model.loadings, i);
      largestStep = std::max(largestStep, std::abs(best - model.loadings[i]));
      model.loadings[i] = best;
    }
    model.hasConverged = largestStep <= kStill;
  }

  const double sum = std::accumulate(model.loadings.begin(), model.loadings.end(), 0.0);
  if (sum < 0.0) {
    for (double& loading : model.loadings) loading = -loading;
  }
  model.isImproper =
      std::ranges::any_of(model.loadings, [](double loading) { return std::abs(loading) >= 1.0; });
  return model;
}

}  // namespace analysis
