#include "analysis/summary/answer_checks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "analysis/numerics/exact_arithmetic.h"

namespace analysis {
namespace {

/// Sums of squares of a one-way layout, added up over methods.
struct OneWaySums {
  double between = 0.0;
  double within = 0.0;
  double betweenDegreesOfFreedom = 0.0;
  double withinDegreesOfFreedom = 0.0;
  double weightedGroupSize = 0.0;  ///< Searle's mean group size n₀, times betweenDegreesOfFreedom
};

struct Cell {
  double n = 0.0;
  double sum = 0.0;
  double square = 0.0;
};

void addMethod(const std::vector<Cell>& cells, OneWaySums& layout) {
  double n = 0.0;
  double sum = 0.0;
  double squaresOfN = 0.0;
  double groups = 0.0;
  for (const auto& cell : cells) {
    if (cell.n == 0.0) continue;
    ++groups;
    n += cell.n;
    sum += cell.sum;
    squaresOfN += cell.n * cell.n;
  }
  if (groups < 2.0) return;
  for (const auto& cell : cells) {
    if (cell.n == 0.0) continue;
    const double apart = cell.sum / cell.n - sum / n;
    layout.between += cell.n * apart * apart;
    layout.within += cell.square - cell.sum * cell.sum / cell.n;
  }
  layout.betweenDegreesOfFreedom += groups - 1.0;
  layout.withinDegreesOfFreedom += n - groups;
  layout.weightedGroupSize += n - squaresOfN / n;
}

}  // namespace

AnswerDependence dependenceOf(const AnswerTable& table) {
  std::vector<std::vector<Cell>> cells(
      table.methods.size(), std::vector<Cell>(table.participants.size()));
  std::set<std::size_t> people;
  for (const auto& answer : table.answers) {
    auto& cell = cells[answer.method][answer.participant];
    const double score = answer.score - table.lowest;
    cell.n += 1.0;
    cell.sum += score;
    cell.square += score * score;
    people.insert(answer.participant);
  }
  OneWaySums layout;
  for (const auto& method : cells) addMethod(method, layout);
  AnswerDependence dependence{.answers = table.answers.size(), .participants = people.size()};
  if (layout.betweenDegreesOfFreedom == 0.0 || layout.withinDegreesOfFreedom == 0.0)
    return dependence;
  const double size = layout.weightedGroupSize / layout.betweenDegreesOfFreedom;
  const double between = layout.between / layout.betweenDegreesOfFreedom;
  const double within = layout.within / layout.withinDegreesOfFreedom;
  const double all = between + (size - 1.0) * within;
  if (!(all > 0.0)) return dependence;
  dependence.intraclassCorrelation = (between - within) / all;
  dependence.designEffect = 1.0 + (size - 1.0) * *dependence.intraclassCorrelation;
  return dependence;
}

namespace {

/// Accumulates a mean.
struct MeanAccumulator {
  double sum = 0.0;
  std::size_t count = 0;

  void add(double value) {
    sum += value;
    ++count;
  }
  double mean() const { return sum / static_cast<double>(count); }
};

using MeansByPosition = std::map<int, MeanAccumulator>;

/// Every participant's scores minus the mean of their method, summed by position.
std::vector<MeansByPosition> residuals(const AnswerTable& table, double& grandMean) {
  std::vector<MeanAccumulator> ofMethod(table.methods.size());
  MeanAccumulator all;
  for (const auto& answer : table.answers) {
    ofMethod[answer.method].add(answer.score);
    all.add(answer.score);
  }
  grandMean = all.count > 0 ? all.mean() : 0.0;
  std::vector<MeansByPosition> rows(table.participants.size());
  for (const auto& answer : table.answers) {
    rows[answer.participant][answer.position].add(answer.score - ofMethod[answer.method].mean());
  }
  return rows;
}

/// The slope of the least-squares line through one participant's averages; std::nullopt for fewer
/// than two positions.
std::optional<double> slopeOf(const MeansByPosition& row) {
  if (row.size() < 2) return std::nullopt;
  MeanAccumulator x;
  MeanAccumulator y;
  for (const auto& [position, sum] : row) {
    x.add(position);
    y.add(sum.mean());
  }
  double products = 0.0;
  double squares = 0.0;
  for (const auto& [position, sum] : row) {
    const double away = position - x.mean();
    products += away * (sum.mean() - y.mean());
    squares += away * away;
  }
  return products / squares;
}

/// The size of the scores, times their number: sums of this size leave rounding errors.
double sizeOf(const AnswerTable& table) {
  double size = 0.0;
  for (const auto& answer : table.answers) size = std::max(size, std::abs(answer.score));
  return size * static_cast<double>(table.answers.size());
}

/// Whether position and method are not confounded: some method came at more than one position.
bool isPositionUnconfounded(const AnswerTable& table) {
  std::map<std::size_t, int> positionOf;
  for (const auto& answer : table.answers) {
    const auto [first, isNew] = positionOf.emplace(answer.method, answer.position);
    if (!isNew && first->second != answer.position) return true;
  }
  return false;
}

}  // namespace

PositionEffect positionEffect(const AnswerTable& table, double level) {
  double grandMean = 0.0;
  const auto rows = residuals(table, grandMean);
  std::map<int, std::vector<double>> byPosition;
  std::vector<double> slopes;
  for (const auto& row : rows) {
    for (const auto& [position, sum] : row) byPosition[position].push_back(sum.mean());
    if (const auto slope = slopeOf(row)) slopes.push_back(*slope);
  }
  const double size = sizeOf(table);
  const auto testAgainstZero = [&](const std::vector<double>& values) {
    return pairedTTest(withoutRoundingNoise(values), size);
  };
  PositionEffect effect;
  if (!table.answers.empty() && !isPositionUnconfounded(table)) {
    effect.slope.reason = reason("one_position_each");
    return effect;
  }
  for (const auto& [position, values] : byPosition) {
    const auto test = testAgainstZero(values);
    PositionMean mean{.position = position, .participants = values.size()};
    mean.mean = grandMean + test.meanDifference.value_or(values.front());
    if (auto interval = confidenceInterval(test, level)) {
      mean.interval = {interval->low + grandMean, interval->high + grandMean};
    }
    effect.positions.push_back(mean);
  }
  effect.slope = testAgainstZero(slopes);
  effect.slopeInterval = confidenceInterval(effect.slope, level);
  return effect;
}

namespace {

/// One row per participant who answered all statements that were asked about a method; a statement
/// that was asked in several rounds is averaged over them.
std::vector<std::vector<double>> completeRows(const AnswerTable& table, std::size_t method) {
  std::map<std::size_t, std::map<std::size_t, std::vector<double>>> rows;
  std::map<std::size_t, int> statements;
  for (const auto& answer : table.answers) {
    if (answer.method != method) continue;
    rows[answer.participant][answer.statement].push_back(answer.score);
    ++statements[answer.statement];
  }
  std::vector<std::vector<double>> complete;
  for (const auto& [participant, scores] : rows) {
    if (scores.size() < statements.size()) continue;
    std::vector<double> row;
    for (const auto& [statement, values] : scores) {
      double sum = 0.0;
      for (const double value : values) sum += value;
      row.push_back(sum / static_cast<double>(values.size()));
    }
    complete.push_back(std::move(row));
  }
  return complete;
}

}  // namespace

ScaleChecks scaleChecks(const AnswerTable& table) {
  ScaleChecks checks;
  const auto means = table.participantMeans();
  std::vector<std::vector<double>> groups;
  for (std::size_t method = 0; method < table.methods.size(); ++method) {
    std::vector<double> values;
    for (const auto& row : means) {
      if (row[method]) values.push_back(*row[method]);
    }
    groups.push_back(withoutRoundingNoise(values));
    const auto rows = completeRows(table, method);
    checks.methods.push_back(
        {.method = table.methods[method],
         .normality = shapiroWilkTest(groups.back()),
         .alpha = cronbachAlpha(rows),
         .omega = omegaTotal(rows)});
  }
  checks.spread = brownForsytheTest(groups);
  return checks;
}

}  // namespace analysis
