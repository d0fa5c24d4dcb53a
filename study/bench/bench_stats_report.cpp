// What `palpate bench stats` makes of its runs.
#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "study/bench/bench_stats.h"

namespace study::app {
namespace {

/// In seconds for so many answers, at most: what was asked for at a million and at ten million.
double wantedSeconds(std::int64_t answers) {
  constexpr double kMillion = 1e6;
  return std::max(0.15, 0.13 * static_cast<double>(answers) / kMillion);
}

std::vector<Cell> timesOf(const std::string& way, const std::vector<double>& seconds) {
  return {
      way,
      static_cast<std::int64_t>(seconds.size()),
      1e3 * seconds.front(),
      1e3 * quantileOf(seconds, 0.5),
      1e3 * quantileOf(seconds, 0.99)};
}

DataTable timeTable(const StatsMeasurement& measured) {
  DataTable table{
      .name = "times",
      .description = fmt::format("Times [ms] with {} answers", measured.answers),
      .columns = {
          {"way", "Way"},
          {"times", "Times"},
          {"first_ms", "First"},
          {"p50_ms", "Median"},
          {"p99_ms", "p99"},
          {"times_ours", "Median, times ours"},
          {"largest_difference", "Largest difference"},
          {"remark", "Remark"}}};
  const double ours = quantileOf(measured.ours.seconds, 0.5);
  const auto add = [&](const TableRun& run, const std::string& remark) {
    if (run.seconds.empty()) {
      table.rows.push_back({run.way, std::int64_t{0}, {}, {}, {}, {}, {}, run.absence});
      return;
    }
    auto row = timesOf(run.way, run.seconds);
    row.emplace_back(quantileOf(run.seconds, 0.5) / ours);
    row.emplace_back(largestDifference(measured.ours.rows, run.rows));
    row.emplace_back(remark);
    table.rows.push_back(std::move(row));
  };
  add(measured.ours, fmt::format("{:.1f} MB at most", measured.memory));
  auto processor = timesOf("… of that, a processor was busy", measured.processor);
  processor.resize(table.columns.size());
  table.rows.push_back(std::move(processor));
  auto edits = timesOf("palpate, after an answer was changed", measured.edits);
  edits.emplace_back(quantileOf(measured.edits, 0.5) / ours);
  edits.emplace_back(measured.isSameAfterEdits ? 0.0 : std::numeric_limits<double>::infinity());
  edits.emplace_back("against counting everything once more");
  table.rows.push_back(std::move(edits));
  auto writing = timesOf("… the change itself, safe on the disk", measured.writing);
  writing.resize(table.columns.size());
  table.rows.push_back(std::move(writing));
  for (const auto& peer : measured.peers) add(peer, peer.version);
  return table;
}

DataTable resultTable(const StatsMeasurement& measured) {
  DataTable table{
      .name = "table",
      .description = "SYNTHETIC: the comparisons, by everybody who made them",
      .columns = {
          {"way", "Way"},
          {"cohort", "Cohort"},
          {"group1", "First"},
          {"group2", "Second"},
          {"mean1", "Mean of the first"},
          {"mean2", "… of the second"},
          {"variance1", "Variance of the first"},
          {"variance2", "… of the second"},
          {"t", "t"},
          {"p", "p, not corrected"}}};
  const auto add = [&](const TableRun& run) {
    for (const auto& r : run.rows) {
      table.rows.push_back(
          {run.way,
           r.cohort,
           r.first,
           r.second,
           r.mean1,
           r.mean2,
           r.variance1,
           r.variance2,
           r.t,
           r.p});
    }
  };
  add(measured.ours);
  for (const auto& peer : measured.peers) add(peer);
  return table;
}

}  // namespace

std::vector<Target> statsTargets(const StatsMeasurement& measured) {
  constexpr double kNoDifference = 1e-9;
  std::vector<Target> targets{
      {"statistics",
       fmt::format("{} answers, database to table [s]", measured.answers),
       quantileOf(measured.ours.seconds, 0.5),
       wantedSeconds(measured.answers),
       true},
      {"statistics",
       "one answer changed, new table [ms]",
       1e3 * quantileOf(measured.edits, 0.5),
       1.0,
       true},
      {"statistics", "memory of the whole process [MB]", measured.memory, 50.0, true}};
  for (const auto& peer : measured.peers) {
    if (peer.seconds.empty()) continue;
    targets.push_back(
        {"statistics",
         "largest difference to " + peer.way,
         largestDifference(measured.ours.rows, peer.rows),
         kNoDifference,
         true});
  }
  return targets;
}

report::Document statsReport(const StatsMeasurement& measured) {
  return {
      .title = "From answers to the table: how fast",
      .lead =
          {fmt::format(
               "SYNTHETIC: {} answers of {} people who do not exist, in a database of {:.0f} MB "
               "that was made for this ({:.1f} s) and is gone.",
               measured.answers,
               measured.sessions,
               measured.databaseSize,
               measured.making),
           "From opening the study to all declared comparisons, Welch's test, corrected; in a "
           "process of its own. Peers read, turn negative statements round, and make the same "
           "table; their time counts from when their libraries are loaded. The difference is the "
           "largest of means and variances, and of t as a share of it."},
      .parts = {
          {.heading = "Times",
           .paragraphs = {},
           .figures = {},
           .tables = {timeTable(measured), targetTable(statsTargets(measured))}},
          {.heading = "The table",
           .paragraphs = {},
           .figures = {},
           .tables = {resultTable(measured)}},
          {.heading = "The machine", .paragraphs = {}, .figures = {}, .tables = {machineTable()}}}};
}

}  // namespace study::app
