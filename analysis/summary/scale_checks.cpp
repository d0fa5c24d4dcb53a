#include "analysis/summary/scale_checks.h"

#include <map>

#include "analysis/numerics/exact_arithmetic.h"

namespace analysis {
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
