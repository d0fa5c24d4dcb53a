#include <algorithm>

#include "study/report/html_writer.h"
#include "study/report/study_parts.h"
#include "study/results/apa_text.h"
#include "study/results/vote_tables.h"

namespace study::report {
namespace {

class PreferenceWriter : HtmlWriter {
 public:
  using HtmlWriter::HtmlWriter;

  std::string all() {
    if (section_.results.votes.empty()) return {};
    const auto tables = voteTables(section_.results);
    for (const auto& one : tables) putVoteTable(one);
    std::size_t leftOut = 0;
    for (const auto& vote : section_.results.votes) leftOut += vote.leftOut;
    if (leftOut > 0) {
      const auto counted = count(
          leftOut,
          "Not counted: {} vote of a participant who did not feel every alternative.",
          "Not counted: {} votes of participants who did not feel every alternative.");
      put("<p class=\"note\">{}</p>", counted);
    }
    const auto exact = say(
        "Exact multinomial test of equal shares, for each round by itself (exploratory): p is the "
        "probability of all outcomes that are no more probable than the one observed.");
    const bool isTested = std::ranges::any_of(
        section_.results.votes, [](const auto& vote) { return vote.test.exactP.has_value(); });
    if (isTested) put("<p class=\"note\">{}</p>", exact);
    const auto many = std::ranges::find_if(
        section_.results.votes, [](const auto& vote) { return !vote.test.exactP && vote.test.p; });
    if (many != section_.results.votes.end()) {
      put("<p class=\"note\">χ²: {}.</p>", escaped(section_.words(many->test.reason)));
    }
    if (std::ranges::any_of(tables, hasSums)) {
      note(
          "Sums count a participant once a round. Votes of one person are not independent, so sums "
          "are not tested.");
    }
    if (!hasIntervals()) return std::move(html_);
    figure(
        section_.figures.votes,
        "Preferences by cohort and round, with Wilson’s 95 % intervals; dashed: equal shares.");
    return std::move(html_);
  }

 private:
  /// Whether an interval would be of a single person's choice.
  static bool isOfOneVote(const VoteResult& vote) { return vote.votes.total() < 2; }
  bool hasIntervals() const { return !std::ranges::all_of(section_.results.votes, isOfOneVote); }

  static bool hasSums(const VoteTable& votes) {
    return votes.total.total() > 0 && std::ranges::any_of(votes.cohorts, [](const auto& cohort) {
             return cohort.rounds.size() > 1;
           });
  }

  /// As Table 4 of the punch paper: by cohort and round, with sums and the total.
  void putVoteTable(const VoteTable& votes) {
    std::vector<std::string> columns{say("Cohort"), textHeading(say("After"))};
    for (const auto& option : votes.options) columns.push_back(condition(option));
    columns.push_back(say("exact p"));
    const auto plain = say("How many participants named each method");
    const auto withIntervals =
        say("How many participants named each method, with Wilson’s 95 % interval");
    table(hasIntervals() ? withIntervals : plain, columns);
    for (const auto& one : votes.cohorts) {
      if (one.sum.total() == 0) continue;
      for (const auto* vote : one.rounds) putVoteRow(*vote);
      if (one.rounds.size() > 1) putVoteRow(cohort(one.cohort), say("Sum"), one.sum);
    }
    const auto areCast = [](const auto& one) { return one.sum.total() > 0; };
    if (std::ranges::count_if(votes.cohorts, areCast) > 1)
      putVoteRow(say("Total"), {}, votes.total);
    endTable();
  }

  void putVoteRow(
      const std::string& who, const std::string& when, const analysis::VoteCounts& sum) {
    std::vector<std::string> cells{who, when};
    for (const auto& share : sum.shares()) cells.push_back(std::to_string(share.votes));
    cells.emplace_back();
    row(cells);
  }

  void putVoteRow(const VoteResult& vote) {
    std::vector<std::string> cells{cohort(vote.cohort), escaped(section_.blockTitle(vote.block))};
    const auto shares = vote.votes.shares();
    for (std::size_t i = 0; i < shares.size(); ++i) {
      std::string cell = std::to_string(shares[i].votes);
      if (i < vote.intervals.size() && vote.intervals[i] && !isOfOneVote(vote)) {
        cell += fmt::format(
            " [{} %, {} %]",
            rounded(100.0 * vote.intervals[i]->low, 0),
            rounded(100.0 * vote.intervals[i]->high, 0));
      }
      cells.push_back(cell);
    }
    cells.push_back(
        vote.test.exactP || !vote.test.p ? cellOfP(vote.test.exactP)
                                         : "χ²: " + cellOfP(vote.test.p));
    row(cells);
  }
};

}  // namespace

std::string preferencesAsHtml(const ReportSection& section) {
  return PreferenceWriter(section).all();
}

}  // namespace study::report
