#include <algorithm>

#include "study/report/html_writer.h"
#include "study/report/study_parts.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

class PreferenceWriter : HtmlWriter {
 public:
  using HtmlWriter::HtmlWriter;

  std::string all() {
    if (s_.results.votes.empty()) return {};
    heading("Preferences");
    std::vector<std::vector<std::string>> sets;
    for (const auto& vote : s_.results.votes) {
      auto options = optionsOf(vote);
      if (std::find(sets.begin(), sets.end(), options) == sets.end()) {
        sets.push_back(std::move(options));
      }
    }
    for (const auto& options : sets) tableOf(options);
    note("Exact multinomial test of equal shares, for each round by itself (exploratory).");
    figure(
        s_.figures.votes,
        "Preferences by cohort and round, with Wilson’s 95 % intervals; dashed: equal shares.");
    return std::move(html_);
  }

 private:
  static std::vector<std::string> optionsOf(const VoteResult& vote) {
    std::vector<std::string> options;
    for (const auto& share : vote.votes.shares()) options.push_back(share.option);
    return options;
  }

  /// The table of all votes between the same renderings.
  void tableOf(const std::vector<std::string>& options) {
    std::vector<std::string> columns{say("Cohort"), say("After")};
    for (const auto& option : options) columns.push_back(condition(option));
    columns.push_back(say("exact p"));
    table(say("How many participants named each method, with Wilson’s 95 % interval"), columns);
    for (const auto& flow : s_.results.flow) {
      for (const auto& vote : s_.results.votes) {
        if (vote.cohort == flow.cohort && optionsOf(vote) == options) votes(vote);
      }
    }
    endTable();
  }

  void votes(const VoteResult& vote) {
    std::vector<std::string> cells{cohort(vote.cohort), escaped(vote.block)};
    const auto shares = vote.votes.shares();
    for (std::size_t i = 0; i < shares.size(); ++i) {
      std::string cell = std::to_string(shares[i].votes);
      if (i < vote.intervals.size() && vote.intervals[i]) {
        cell += fmt::format(
            " [{:.0f} %, {:.0f} %]",
            100.0 * vote.intervals[i]->low,
            100.0 * vote.intervals[i]->high);
      }
      cells.push_back(cell);
    }
    cells.push_back(escaped(pInWords(vote.test.exactP)));
    row(cells);
  }
};

}  // namespace

std::string preferencesAsHtml(const ReportSection& section) {
  return PreferenceWriter(section).all();
}

}  // namespace study::report
