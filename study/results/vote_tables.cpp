#include "study/results/vote_tables.h"

#include <algorithm>

namespace study {
namespace {

std::vector<std::string> optionsOf(const VoteResult& vote) {
  std::vector<std::string> options;
  for (auto& share : vote.votes.shares()) options.push_back(std::move(share.option));
  return options;
}

void add(analysis::VoteCounts& sum, const analysis::VoteCounts& votes) {
  for (const auto& share : votes.shares()) sum.add(share.option, share.votes);
}

VoteTable tableOf(const Results& results, const std::vector<std::string>& options) {
  const analysis::VoteCounts none(options);
  VoteTable table{.options = options, .cohorts = {}, .total = none};
  for (const auto& flow : results.flow) {
    CohortVotes cohort{.cohort = flow.cohort, .rounds = {}, .sum = none};
    for (const auto& vote : results.votes) {
      if (vote.cohort != flow.cohort || optionsOf(vote) != options) continue;
      cohort.rounds.push_back(&vote);
      add(cohort.sum, vote.votes);
    }
    add(table.total, cohort.sum);
    if (!cohort.rounds.empty()) table.cohorts.push_back(std::move(cohort));
  }
  return table;
}

}  // namespace

std::vector<VoteTable> voteTables(const Results& results) {
  std::vector<VoteTable> tables;
  for (const auto& vote : results.votes) {
    const auto options = optionsOf(vote);
    if (std::ranges::find(tables, options, &VoteTable::options) != tables.end()) continue;
    tables.push_back(tableOf(results, options));
  }
  return tables;
}

}  // namespace study
