#include "analysis/summary/answer_dependence.h"

#include <set>
#include <vector>

namespace analysis {
namespace {

/// Sums of squares of a one-way layout, added up over methods.
struct Layout {
  double between = 0.0;
  double within = 0.0;
  double betweenFreedom = 0.0;
  double withinFreedom = 0.0;
  double weighted = 0.0;  ///< Searle's n₀ times betweenFreedom
};

struct Cell {
  double n = 0.0;
  double sum = 0.0;
  double square = 0.0;
};

void addMethod(const std::vector<Cell>& cells, Layout& layout) {
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
  layout.betweenFreedom += groups - 1.0;
  layout.withinFreedom += n - groups;
  layout.weighted += n - squaresOfN / n;
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
  Layout layout;
  for (const auto& method : cells) addMethod(method, layout);
  AnswerDependence dependence{.answers = table.answers.size(), .participants = people.size()};
  if (layout.betweenFreedom == 0.0 || layout.withinFreedom == 0.0) return dependence;
  const double size = layout.weighted / layout.betweenFreedom;
  const double between = layout.between / layout.betweenFreedom;
  const double within = layout.within / layout.withinFreedom;
  const double all = between + (size - 1.0) * within;
  if (!(all > 0.0)) return dependence;
  dependence.intraclassCorrelation = (between - within) / all;
  dependence.designEffect = 1.0 + (size - 1.0) * *dependence.intraclassCorrelation;
  return dependence;
}

}  // namespace analysis
