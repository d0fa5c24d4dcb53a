#include "study/export/votes_table.h"

#include "analysis/effects/share_interval.h"
#include "study/results/results.h"

namespace study {
namespace {

constexpr double kVoteLevel = 0.95;

std::vector<Column> columnsOfVotes() {
  return {
      {"run_mode", "live, pilot or simulated"},
      {"cohort", "Group of participants"},
      {"preference", "Phase of the protocol in which was voted"},
      {"block", "Phase of the protocol"},
      {"item_id", "Question"},
      {"condition_code", "Which rendering it was, as a code that means the same in every row"},
      {"votes", "How many preferred it"},
      {"votes_total", "How many voted at all"},
      {"share", "votes / votes_total"},
      {"conf_level", "Confidence of the intervals"},
      {"share_low", "Wilson's interval of the share"},
      {"share_high", "…"},
      {"share_low_exact", "Clopper and Pearson's interval of the share"},
      {"share_high_exact", "…"},
      {"p_exact", "That all are preferred equally often: exact multinomial test"},
      {"chi2", "The same by the chi-squared test, only roughly where votes are few"},
      {"chi2_df", "Its degrees of freedom"},
      {"p_chi2", "Its p"},
      {"reason", "Why something is missing"}};
}

/// The questions of a preference whose options are the alternatives of a block.
std::string votedOn(const protocols::LoadedProtocol& loaded, const std::string& phase) {
  std::string items;
  const auto* instrument = loaded.instrument(loaded.protocol.phase(phase)->instrument);
  for (const auto& item : instrument->items) {
    if (item.optionSource != questionnaires::OptionSource::Alternatives) continue;
    items += (items.empty() ? "" : " ") + item.id;
  }
  return items;
}

std::vector<Cell> rowOfVotes(
    const VoteResult& vote, const analysis::VoteShare& share, const std::string& code) {
  const auto total = vote.votes.total();
  const auto wilson = analysis::wilsonInterval(share.votes, total, kVoteLevel);
  const auto exact = analysis::clopperPearsonInterval(share.votes, total, kVoteLevel);
  const auto low = [](const auto& interval) { return interval ? Cell(interval->low) : Cell(); };
  const auto high = [](const auto& interval) { return interval ? Cell(interval->high) : Cell(); };
  return {
      code,
      static_cast<std::int64_t>(share.votes),
      static_cast<std::int64_t>(total),
      cellOf(share.share),
      kVoteLevel,
      low(wilson),
      high(wilson),
      low(exact),
      high(exact),
      cellOf(vote.test.exactP),
      cellOf(vote.test.chiSquared),
      cellOf(vote.test.degreesOfFreedom),
      cellOf(vote.test.p),
      vote.test.reason.empty() ? Cell() : Cell(base::describe(vote.test.reason))};
}

}  // namespace

DataTable votesTable(Study& study, const ExportOptions& options) {
  DataTable table{
      .name = "votes",
      .description = "One row per vote, cohort and rendering: how many preferred it.",
      .columns = columnsOfVotes(),
      .rows = {}};
  const auto codes = conditionCodes(study);
  std::vector<RunMode> modes{RunMode::Live, RunMode::Pilot, RunMode::Simulated};
  if (options.runMode) modes = {*options.runMode};
  for (const auto mode : modes) {
    const auto results = computeResults(study, mode);
    if (results.completed() == 0) continue;
    for (const auto& vote : results.votes) {
      const std::vector<Cell> head{
          std::string(nameOf(mode)),
          vote.cohort,
          vote.phase,
          vote.block,
          votedOn(study.protocol(), vote.phase)};
      for (const auto& share : vote.votes.shares()) {
        auto& row = table.rows.emplace_back(head);
        const auto more = rowOfVotes(vote, share, codes.at(share.option));
        row.insert(row.end(), more.begin(), more.end());
      }
    }
  }
  return table;
}

}  // namespace study
