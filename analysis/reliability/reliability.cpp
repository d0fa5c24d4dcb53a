#include "analysis/reliability/reliability.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "analysis/data/moments.h"
#include "analysis/data/two_way_layout.h"
#include "analysis/numerics/distributions.h"
#include "analysis/numerics/tail_probabilities.h"

namespace analysis {
namespace {

/// Items as columns of deviations from their mean, scaled to length 1, so that correlations are
/// scalar products.
struct StandardisedItems {
  std::vector<std::vector<double>> columns;
  std::vector<double> deviations;  ///< standard deviations, in units of the largest
};

bool isConstant(const std::vector<double>& column) {
  return std::ranges::all_of(column, [&](double value) { return value == column.front(); });
}

std::vector<double> standardised(const std::vector<double>& column, const Moments& moments) {
  const double unit = std::ldexp(1.0, -moments.exponent);
  const auto degreesOfFreedom = static_cast<double>(moments.n - 1);
  const DoubleDouble length = squareRoot(moments.variance * degreesOfFreedom);
  std::vector<double> result;
  result.reserve(column.size());
  for (const double value : column) {
    result.push_back(((DoubleDouble(value * unit) - moments.mean) / length).high);
  }
  return result;
}

StandardisedItems standardisedItems(std::span<const std::vector<double>> columns) {
  StandardisedItems items;
  std::vector<Moments> moments;
  int exponent = 0;
  for (const auto& column : columns) {
    moments.push_back(momentsOf(column));
    exponent =
        moments.size() == 1 ? moments.back().exponent : std::max(exponent, moments.back().exponent);
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const DoubleDouble deviation = squareRoot(moments[i].variance);
    items.deviations.push_back(std::ldexp(deviation.high, moments[i].exponent - exponent));
    items.columns.push_back(standardised(columns[i], moments[i]));
  }
  return items;
}

std::vector<std::vector<double>> correlationsOf(const StandardisedItems& items) {
  const std::size_t k = items.columns.size();
  std::vector<std::vector<double>> correlations(k, std::vector<double>(k, 1.0));
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      DoubleDouble sum;
      for (std::size_t row = 0; row < items.columns[i].size(); ++row) {
        sum = sum + DoubleDouble::product(items.columns[i][row], items.columns[j][row]);
      }
      correlations[i][j] = correlations[j][i] = std::clamp(sum.high, -1.0, 1.0);
    }
  }
  return correlations;
}

double omegaOf(const std::vector<double>& loadings, const std::vector<double>& deviations) {
  double common = 0.0;
  double own = 0.0;
  for (std::size_t i = 0; i < loadings.size(); ++i) {
    const double part = deviations[i] * loadings[i];
    common += part;
    own += deviations[i] * deviations[i] - part * part;
  }
  return common * common / (common * common + own);
}

Reason whyNoFactorModel(std::span<const std::vector<double>> columns, std::size_t respondents) {
  if (respondents < 3) return reason("three_respondents_needed");
  if (columns.size() < 3) return reason("three_items_needed");
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (isConstant(columns[i])) {
      return reason("item_without_variance", i + 1);
    }
  }
  return {};
}

}  // namespace

CronbachAlpha cronbachAlpha(std::span<const std::vector<double>> answers, double level) {
  requireConfidenceLevel(level);
  const TwoWayLayout layout = twoWayLayout(answers);
  CronbachAlpha alpha;
  alpha.respondents = layout.rows;
  alpha.items = layout.columns;
  alpha.level = level;
  if (layout.rows < 2 || layout.columns < 2) {
    alpha.reason = reason("alpha_needs_two");
    return alpha;
  }
  if (layout.rowSquares.isZero()) {
    alpha.reason = reason("sums_same");
    return alpha;
  }

  const DoubleDouble ratio = layout.residualMeanSquare() / layout.rowMeanSquare();
  alpha.value = (DoubleDouble(1.0) - ratio).high;
  if (*alpha.value < 0.0) alpha.reason = reason("negative_alpha");
  const auto df1 = static_cast<double>(layout.rows - 1);
  const FisherDistribution distribution(df1, df1 * static_cast<double>(layout.columns - 1));
  const double tail = 0.5 * (1.0 - level);
  alpha.interval = Interval{
      .low = 1.0 - ratio.high * distribution.upperQuantile(tail),
      .high = 1.0 - ratio.high * distribution.upperQuantile(1.0 - tail)};
  return alpha;
}

OmegaTotal omegaTotal(std::span<const std::vector<double>> answers) {
  const TwoWayLayout layout = twoWayLayout(answers);  // used for its checks and sizes
  OmegaTotal omega;
  omega.respondents = layout.rows;
  omega.items = layout.columns;
  std::vector<std::vector<double>> columns(layout.columns);
  for (const auto& row : answers) {
    for (std::size_t item = 0; item < row.size(); ++item) columns[item].push_back(row[item]);
  }
  omega.reason = whyNoFactorModel(columns, layout.rows);
  if (!omega.reason.empty()) return omega;

  const StandardisedItems items = standardisedItems(columns);
  const OneFactorModel model = fitOneFactor(correlationsOf(items));
  if (!model.hasConverged) {
    omega.reason = reason("no_loadings");
    return omega;
  }
  omega.loadings = model.loadings;
  omega.isImproper = model.isImproper;
  omega.value = omegaOf(model.loadings, items.deviations);
  return omega;
}

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

/// The first principal component by power iteration, used as starting values.
Loadings principalComponent(Correlations correlations) {
  constexpr int kSteps = 200;
  Loadings component(correlations.size());
  for (std::size_t i = 0; i < component.size(); ++i) {
    // Slightly uneven, because a constant vector may be orthogonal to the principal component.
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

/// The best value of one loading for given other loadings.
double bestLoading(Correlations correlations, const Loadings& loadings, std::size_t i) {
  const double squares = product(loadings, loadings) - loadings[i] * loadings[i];
  if (!(squares > 0.0)) return loadings[i];
  const double explained = product(correlations[i], loadings) - correlations[i][i] * loadings[i];
  return std::clamp(explained / squares, -1.0, 1.0);
}

}  // namespace

OneFactorModel fitOneFactor(std::span<const std::vector<double>> correlations) {
  constexpr int kMostSweeps = 100'000;
  constexpr double kConvergedChange = 4e-15;  // change of a loading: a few units in the last place
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
    model.hasConverged = largestStep <= kConvergedChange;
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
