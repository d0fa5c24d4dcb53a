#include "analysis/data/answer_table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "analysis/numerics/exact_arithmetic.h"

namespace analysis {
namespace {

struct Sum {
  std::int64_t of = 0;
  std::int64_t count = 0;
};

}  // namespace

int AnswerTable::aboveMiddle() const {
  return static_cast<int>(std::floor(std::midpoint<double>(lowest, highest))) + 1;
}

LikertCounts AnswerTable::countsOf(std::size_t method) const {
  LikertCounts counts(lowest, highest);
  for (const auto& answer : answers) {
    if (answer.method == method) counts.add(answer.score);
  }
  return counts;
}

std::vector<std::vector<std::optional<double>>> AnswerTable::participantMeans() const {
  std::vector<std::vector<Sum>> sums(participants.size(), std::vector<Sum>(methods.size()));
  for (const auto& answer : answers) {
    auto& sum = sums[answer.participant][answer.method];
    sum.of += answer.score;
    ++sum.count;
  }
  std::vector<std::vector<std::optional<double>>> means;
  for (const auto& row : sums) {
    auto& of = means.emplace_back();
    for (const auto& sum : row) {
      of.push_back(
          sum.count > 0 ? std::optional(exactQuotient(sum.of, sum.count).high) : std::nullopt);
    }
  }
  return means;
}

std::vector<double> CompleteMeans::of(std::size_t method) const {
  std::vector<double> column;
  column.reserve(means.size());
  for (const auto& row : means) column.push_back(row[method]);
  return column;
}

CompleteMeans completeMeans(const AnswerTable& table, const std::vector<std::size_t>& methods) {
  CompleteMeans complete;
  const auto all = table.participantMeans();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto has = [&](std::size_t method) { return all[i][method].has_value(); };
    if (!std::all_of(methods.begin(), methods.end(), has)) {
      complete.leftOut.push_back(i);
      continue;
    }
    complete.participants.push_back(i);
    auto& row = complete.means.emplace_back();
    for (const std::size_t method : methods) row.push_back(*all[i][method]);
  }
  return complete;
}

}  // namespace analysis
