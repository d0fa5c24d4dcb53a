#include "analysis/summary/position_effect.h"

#include <map>

#include "analysis/numerics/exact_arithmetic.h"

namespace analysis {
namespace {

/// A mean in the making.
struct Sum {
  double sum = 0.0;
  std::size_t count = 0;

  void add(double value) {
    sum += value;
    ++count;
  }
  double mean() const { return sum / static_cast<double>(count); }
};

using ByPosition = std::map<int, Sum>;

/// Every participant's scores by position, without the means of the methods.
std::vector<ByPosition> residuals(const AnswerTable& table, double& grandMean) {
  std::vector<Sum> ofMethod(table.methods.size());
  Sum all;
  for (const auto& answer : table.answers) {
    ofMethod[answer.method].add(answer.score);
    all.add(answer.score);
  }
  grandMean = all.count > 0 ? all.mean() : 0.0;
  std::vector<ByPosition> rows(table.participants.size());
  for (const auto& answer : table.answers) {
    rows[answer.participant][answer.position].add(answer.score - ofMethod[answer.method].mean());
  }
  return rows;
}

/// Of the least-squares line through one participant's averages; std::nullopt for fewer than two
/// positions.
std::optional<double> slopeOf(const ByPosition& row) {
  if (row.size() < 2) return std::nullopt;
  Sum x;
  Sum y;
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

/// Of the mean of @p values.
PairedTResult againstNothing(const std::vector<double>& values) {
  return pairedTTest(withoutRoundingNoise(values), std::vector<double>(values.size(), 0.0));
}

/// Whether some method came at more than one position.
bool isApartFromMethods(const AnswerTable& table) {
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
  PositionEffect effect;
  if (!table.answers.empty() && !isApartFromMethods(table)) {
    effect.slope.reason = reason("one_position_each");
    return effect;
  }
  for (const auto& [position, values] : byPosition) {
    const auto test = againstNothing(values);
    PositionMean mean{.position = position, .participants = values.size()};
    mean.mean = grandMean + test.meanDifference.value_or(values.front());
    if (auto interval = confidenceInterval(test, level)) {
      mean.interval = {interval->low + grandMean, interval->high + grandMean};
    }
    effect.positions.push_back(mean);
  }
  effect.slope = againstNothing(slopes);
  effect.slopeInterval = confidenceInterval(effect.slope, level);
  return effect;
}

}  // namespace analysis
