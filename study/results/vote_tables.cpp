#include "study/results/vote_tables.h"

#include <algorithm>
#include <set>

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

std::optional<MostNamed> mostNamedIn(const Results& results) {
  for (const auto& table : voteTables(results)) {
    MostNamed most{.total = table.total.total()};
    if (most.total == 0) continue;
    for (const auto& share : table.total.shares()) most.votes = std::max(most.votes, share.votes);
    std::vector<std::string> named;
    for (const auto& share : table.total.shares()) {
      if (share.votes == most.votes) named.push_back(share.option);
    }
    if (named.size() > 1) continue;
    std::set<std::string> rounds;
    for (const auto& cohort : table.cohorts) {
      for (const auto* vote : cohort.rounds) rounds.insert(vote->phase);
    }
    most.condition = named.front();
    most.phase = *rounds.begin();
    most.rounds = rounds.size();
    return most;
  }
  return std::nullopt;
}

}  // namespace study
