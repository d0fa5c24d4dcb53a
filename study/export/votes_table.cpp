#include "analysis/data/vote_shares.h"
#include "study/export/condition_codes.h"
#include "study/export/export_parts.h"
#include "study/export/statistics_table.h"
#include "study/export/study_columns.h"

namespace study {
namespace {

constexpr double kVoteLevel = 0.95;

/// A row of votes.csv: how often a condition was preferred.
struct ExportedVote {
  RunMode mode;
  const VoteResult* result = nullptr;
  std::string items;  ///< ids of the preference items
  analysis::VoteShare share;
  std::string conditionCode;
  std::optional<analysis::Interval> wilson;
  std::optional<analysis::Interval> exact;
};

/// A getter for one end of an interval; missing without an interval.
auto endOf(
    std::optional<analysis::Interval> ExportedVote::*interval, double analysis::Interval::*end) {
  return [interval, end](const ExportedVote& row) {
    const auto& known = row.*interval;
    return known ? std::optional((*known).*end) : std::nullopt;
  };
}

/// A getter for a result of the test of equal shares.
template <typename Member>
auto testMember(Member member) {
  return [member](const ExportedVote& row) { return std::invoke(member, row.result->test); };
}

Table<ExportedVote> voteTable() {
  using namespace holds;
  using Vote = ExportedVote;
  using analysis::Interval;
  using Test = decltype(VoteResult::test);
  return {
      .name = "votes",
      .description = "One row per vote, cohort and rendering: how many preferred it.",
      .columns =
          {{"run_mode", OneOf{ValueList::RunModes}, kRunModeDescription, &Vote::mode},
           {"cohort",
            OneOf{ValueList::Cohorts},
            kCohortDescription,
            [](const Vote& row) { return row.result->cohort; }},
           {"site",
            OneOf{ValueList::Sites},
            std::string(kSiteDescription) + "; empty: of all",
            [](const Vote& row) { return row.result->site; }},
           {"preference",
            Text{},
            "Phase of the protocol in which was voted: block of the votes in the responses; block "
            "here "
            "is the phase that had the alternatives",
            [](const Vote& row) { return row.result->phase; }},
           {"block",
            OneOf{ValueList::Blocks},
            "Phase of the protocol",
            [](const Vote& row) { return row.result->block; }},
           {"item_id", Text{}, "Question", &Vote::items},
           conditionCodeColumn<Vote>(),
           {"votes",
            Integer{},
            "How many preferred it",
            [](const Vote& row) { return row.share.votes; }},
           {"votes_total",
            Integer{},
            "How many voted at all",
            [](const Vote& row) { return row.result->votes.total(); }},
           {"share",
            Number{},
            "votes / votes_total",
            [](const Vote& row) { return row.share.share; }},
           {"conf_level",
            Number{},
            "Confidence of the intervals",
            [](const Vote&) { return kVoteLevel; }},
           {"share_low",
            Number{},
            "Wilson's interval of the share",
            endOf(&Vote::wilson, &Interval::low)},
           {"share_high", Number{}, "…", endOf(&Vote::wilson, &Interval::high)},
           {"share_low_exact",
            Number{},
            "Clopper and Pearson's interval of the share",
            endOf(&Vote::exact, &Interval::low)},
           {"share_high_exact", Number{}, "…", endOf(&Vote::exact, &Interval::high)},
           {"p_exact",
            Number{},
            "That all are preferred equally often: exact multinomial test",
            testMember(&Test::exactP)},
           {"chi2",
            Number{},
            "The same by the chi-squared test, only roughly where votes are few",
            testMember(&Test::chiSquared)},
           {"chi2_df", Number{}, "Its degrees of freedom", testMember(&Test::degreesOfFreedom)},
           {"p_chi2", Number{}, "Its p", testMember(&Test::p)},
           {"reason",
            Text{},
            "Why something is missing",
            [](const Vote& row) { return base::describe(row.result->test.reason); }}},
      .revealsCondition = true};
}

/// The ids of the preference items whose options are the alternatives of a block.
std::string preferenceItemsOf(const protocols::LoadedProtocol& loaded, const std::string& phase) {
  std::string items;
  const auto* instrument = loaded.instrument(loaded.protocol.phase(phase)->instrument);
  for (const auto& item : instrument->items) {
    if (item.optionSource != questionnaires::OptionSource::Alternatives) continue;
    items += (items.empty() ? "" : " ") + item.id;
  }
  return items;
}

}  // namespace

ExportedTable votesTable(
    Study& study, const ExportOptions& options, const std::vector<Results>& results) {
  std::vector<ExportedVote> rows;
  for (const auto& one : results) {
    const auto codes = conditionCodes(study, one.runMode, options.codes);
    const auto add = [&](const VoteResult& vote) {
      const auto total = vote.votes.total();
      for (const auto& share : vote.votes.shares()) {
        rows.push_back(
            {.mode = one.runMode,
             .result = &vote,
             .items = preferenceItemsOf(study.protocol(), vote.phase),
             .share = share,
             .conditionCode = codes.at(share.option),
             .wilson = analysis::wilsonInterval(share.votes, total, kVoteLevel),
             .exact = analysis::clopperPearsonInterval(share.votes, total, kVoteLevel)});
      }
    };
    for (const auto& vote : one.votes) add(vote);
    for (const auto& vote : one.siteVotes) add(vote);
  }
  return exportedTable(voteTable(), rows, readersOf(study, options));
}

}  // namespace study
