// palpate-bench collect: the speed of a server to which stations send, compared with plain COPY and
// SQL of the same rows.
#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "study/app/command_options.h"
#include "study/bench/bench_program.h"
#include "study/bench/collect/collected_speed.h"
#include "study/bench/print_result.h"

namespace study::bench {
namespace {

struct CollectOptions {
  std::string out;
  CollectBenchOptions size;
};

IngestSpeed sumOf(const std::vector<IngestSpeed>& parts) {
  IngestSpeed sum;
  for (const auto& part : parts) {
    sum.sent += part.sent;
    sum.copying += part.copying;
    sum.copyingAll += part.copyingAll;
  }
  return sum;
}

DataTable ingestTable(const CollectMeasurement& measured) {
  const auto sum = sumOf(measured.parts);
  const auto answers = static_cast<double>(sum.sent.answers);
  const double megabytes = static_cast<double>(measured.recorded.traceBytes) / 1e6;
  WorkTime copyingTraces;
  for (const auto& each : measured.copyingTraces) copyingTraces += each;
  const double megabytesCopied = megabytes * static_cast<double>(measured.copyingTraces.size());
  const auto row = [](const char* what,
                      const char* unit,
                      double amount,
                      const WorkTime& ours,
                      double amountOfPeer,
                      const WorkTime& peer) {
    const double share = amount / amountOfPeer;
    return std::vector<Cell>{
        std::string(what),
        std::string(unit),
        amount / ours.wall,
        amountOfPeer / peer.wall,
        ours.wall / (peer.wall * share),
        amount / ours.processor,
        amountOfPeer / peer.processor,
        ours.processor / (peer.processor * share)};
  };
  auto withReading = sum.sent.ingesting;
  withReading += sum.sent.reading;
  return {
      .name = "ingest",
      .description = "Into the server, beside plain COPY of the same rows",
      .columns =
          {{"what", "What"},
           {"unit", "Unit"},
           {"ingest", "ingest()"},
           {"copy", "COPY"},
           {"times", "Times as long"},
           {"ingest_processor", "ingest(), of a processor"},
           {"copy_processor", "COPY"},
           {"times_processor", "Times as much"}},
      .rows = {
          row("answers, with all that travels; COPY of the answers",
              "answers/s",
              answers,
              sum.sent.ingesting,
              answers,
              sum.copying),
          row("… COPY of all rows",
              "answers/s",
              answers,
              sum.sent.ingesting,
              answers,
              sum.copyingAll),
          row("… ingest() and what the station does before",
              "answers/s",
              answers,
              withReading,
              answers,
              sum.copyingAll),
          row("samples",
              "MB/s",
              megabytes,
              measured.recorded.traces,
              megabytesCopied,
              copyingTraces)}};
}

DataTable growthTable(const CollectMeasurement& measured) {
  DataTable table{
      .name = "growth",
      .description = {},
      .columns = {
          {"answers_before", "Answers there"},
          {"ingest_answers_per_s", "ingest() [answers/s]"},
          {"copy_answers_per_s", "COPY of all rows [answers/s]"}}};
  for (const auto& part : measured.parts) {
    const auto answers = static_cast<double>(part.sent.answers);
    table.rows.push_back(
        {part.before, answers / part.sent.ingesting.wall, answers / part.copyingAll.wall});
  }
  return table;
}

report::Chart growthChart(const CollectMeasurement& measured) {
  report::Chart chart{
      .x = {.title = "answers on the server"},
      .y = {.title = "answers/s", .isLogarithmic = true},
      .series = {{.title = "ingest()"}, {.title = "COPY of the same rows"}}};
  for (const auto& part : measured.parts) {
    const auto before = static_cast<double>(part.before);
    const auto answers = static_cast<double>(part.sent.answers);
    chart.series[0].points.push_back({.x = before, .y = answers / part.sent.ingesting.wall});
    chart.series[1].points.push_back({.x = before, .y = answers / part.copyingAll.wall});
  }
  return chart;
}

DataTable countTable(const CollectMeasurement& measured) {
  const double ours = quantile(measured.counts.ours, 0.5);
  const double bare = quantile(measured.counts.bare, 0.5);
  return {
      .name = "counts",
      .description = "Counts for the pairwise table, by cohort, code and point",
      .columns =
          {{"answers", "Answers"},
           {"sites", "Sites"},
           {"groups", "Groups"},
           {"view_ms", "Analyst's view [ms]"},
           {"bare_ms", "Bare table [ms]"},
           {"times", "Times as long"}},
      .rows = {
          {measured.answers,
           static_cast<std::int64_t>(measured.sites),
           static_cast<std::int64_t>(measured.groups),
           1e3 * ours,
           1e3 * bare,
           ours / bare}}};
}

DataTable pullTable(const CollectMeasurement& measured) {
  return {
      .name = "pull",
      .description = "All of it as a folder ('palpate collect pull')",
      .columns =
          {{"sessions", "Sessions"},
           {"events", "Events"},
           {"seconds", "Time [s]"},
           {"processor_s", "… of a processor [s]"},
           {"answers_per_s", "Answers/s"},
           {"folder_mb", "Folder [MB]"},
           {"memory_before_mb", "Memory before [MB]"},
           {"memory_mb", "… at most [MB]"}},
      .rows = {
          {measured.sessions,
           measured.events,
           measured.pulling.wall,
           measured.pulling.processor,
           static_cast<double>(measured.answers) / measured.pulling.wall,
           measured.pulledMegabytes,
           measured.memoryBefore,
           measured.memory}}};
}

DataTable sizeTable(const CollectMeasurement& measured) {
  DataTable table{
      .name = "sizes",
      .description = "Tables on the server",
      .columns = {
          {"table", "Table"},
          {"rows", "Rows"},
          {"mb", "Rows [MB]"},
          {"indexes_mb", "Indexes [MB]"},
          {"bytes_per_answer", "Bytes an answer"}}};
  for (const auto& each : measured.tables) {
    table.rows.push_back(
        {each.table,
         each.rows,
         static_cast<double>(each.bytes) / 1e6,
         static_cast<double>(each.indexes) / 1e6,
         static_cast<double>(each.bytes + each.indexes) / static_cast<double>(measured.answers)});
  }
  return table;
}

DataTable planTable(const CollectMeasurement& measured) {
  DataTable table{
      .name = "plan",
      .description = "How PostgreSQL counts in the view (EXPLAIN ANALYZE)",
      .columns = {{"plan", "Plan"}}};
  for (const auto& line : measured.plan) table.rows.push_back({line});
  return table;
}

int benchCollect(const CollectOptions& options) {
  const auto measured = measureCollection(options.size);
  printAndWrite(
      options.out,
      "collect",
      {.title = "Many sites into one server: how fast",
       .lead =
           {"A private PostgreSQL server, one station with samples of simulated participants, and "
            "many that repeat its sessions. All of it was removed again. docs/benchmarks.md "
            "explains the columns."},
       .parts = {
           {.heading = "In",
            .figures =
                {{.name = "growth",
                  .caption = "Answers a second, while the tables grow.",
                  .chart = growthChart(measured)}},
            .tables = {ingestTable(measured), growthTable(measured)}},
           {.heading = "Counting", .tables = {countTable(measured), planTable(measured)}},
           {.heading = "Out", .tables = {pullTable(measured)}},
           {.heading = "Sizes", .tables = {sizeTable(measured)}}}});
  for (const auto& problem : measured.problems) fmt::print("FAIL  {}.\n", problem);
  return measured.problems.empty() ? 0 : 1;
}

}  // namespace

void addCollectCommand(CLI::App& program, Action& action) {
  auto [command, options] = app::addCommand(
      program,
      action,
      "collect",
      "Measure how fast a PostgreSQL server takes in, counts and returns the data of many sites",
      benchCollect);
  options.size.folder = std::filesystem::temp_directory_path();
  addOutFolder(*command, options.out);
  auto& size = options.size;
  command->add_option("--answers", size.answers, "Number of answers of all sites together")
      ->check(CLI::Range(std::int64_t{100}, std::int64_t{10'000'000}))
      ->capture_default_str();
  command->add_option("--sites", size.sites, "Number of sites, each with a station")
      ->check(CLI::Range(1, 10'000))
      ->capture_default_str();
  command
      ->add_option(
          "--participants",
          size.participants,
          "Number of simulated participants whose samples are sent, 1 MB of each")
      ->check(CLI::Range(1, 10'000))
      ->capture_default_str();
  command
      ->add_option(
          "--repetitions",
          size.repetitions,
          "Number of times that counts are queried, and that samples are copied (COPY)")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command
      ->add_option(
          "--disk",
          size.folder,
          "Folder in which stations' folders are created (default: that of temporary files)")
      ->check(CLI::ExistingDirectory);
}

}  // namespace study::bench
