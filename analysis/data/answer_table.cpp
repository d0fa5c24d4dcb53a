#include "analysis/data/answer_table.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace analysis {
int AnswerTable::lowestPointAboveMiddle() const {
  return static_cast<int>(std::floor(std::midpoint<double>(lowest, highest))) + 1;
}

AnswerSample AnswerTable::sampleOf(std::size_t method) const {
  std::vector<double> scores;
  for (const auto& answer : answers) {
    if (answer.method == method) scores.push_back(answer.score);
  }
  return sampleOf(scores);
}

AnswerSample AnswerTable::sampleOf(std::span<const double> scores) const {
  if (!isPointScale) return AnswerSample(scores);
  LikertCounts counts(static_cast<int>(lowest), static_cast<int>(highest));
  for (const double score : scores) counts.add(static_cast<int>(score));
  return counts;
}

std::vector<std::vector<std::optional<double>>> AnswerTable::participantMeans() const {
  using Scores = std::vector<double>;
  std::vector<std::vector<Scores>> given(participants.size(), std::vector<Scores>(methods.size()));
  for (const auto& answer : answers) {
    given[answer.participant][answer.method].push_back(answer.score);
  }
  std::vector<std::vector<std::optional<double>>> means;
  for (const auto& row : given) {
    auto& of = means.emplace_back();
    for (const auto& scores : row) of.push_back(sampleOf(scores).mean());
  }
  return means;
}

std::vector<double> CompleteCaseMeans::of(std::size_t method) const {
  std::vector<double> column;
  column.reserve(means.size());
  for (const auto& row : means) column.push_back(row[method]);
  return column;
}

CompleteCaseMeans completeCaseMeans(
    const AnswerTable& table, const std::vector<std::size_t>& methods) {
  CompleteCaseMeans complete;
  const auto all = table.participantMeans();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto has = [&](std::size_t method) { return all[i][method].has_value(); };
    if (!std::ranges::all_of(methods, has)) {
      complete.excludedParticipants.push_back(i);
      continue;
    }
    complete.participants.push_back(i);
    auto& row = complete.means.emplace_back();
    for (const std::size_t method : methods) row.push_back(*all[i][method]);
  }
  return complete;
}

}  // namespace analysis
