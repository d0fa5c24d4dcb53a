// palpate-bench stats: the time from opening a study's database to the table of comparisons.
#include <chrono>
#include <cstdio>
#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "haptics/timing/stopwatch.h"
#include "study/app/command_options.h"
#include "study/bench/bench_program.h"
#include "study/bench/memory.h"
#include "study/bench/print_result.h"
#include "study/bench/synthetic_study.h"
#include "study/model/new_file.h"
#include "study/results/pooled_results.h"

namespace study::bench {
namespace {

namespace fs = std::filesystem;

struct StatsOptions {
  std::string out;
  std::string disk;  ///< folder for the database; empty: the folder for temporary files
  std::int64_t answers = 1'000'000;
  int repetitions = 20;
};

struct StatsMeasurement {
  std::int64_t sessions = 0;
  double databaseSize = 0.0;    ///< [MB]
  std::vector<double> seconds;  ///< times from opening the study to the table [s]
  double memoryBefore = 0.0;    ///< peak before the first run [MB]
  double memory = 0.0;          ///< peak [MB]
  std::uint64_t counted = 0;    ///< number of answers in the table
};

/// Opens a study and computes the comparisons of all its families and cohorts.
/// @return the number of compared answers.
std::uint64_t compareAll(const fs::path& folder) {
  auto study = Study::open(folder, storage::Database::Access::ReadOnly);
  std::uint64_t counted = 0;
  for (const auto& family : pooledResults(study, RunMode::Simulated).families) {
    for (const auto& cohort : family.cohorts) {
      for (const auto& condition : cohort.conditions) counted += condition.answers.total();
    }
  }
  return counted;
}

StatsMeasurement measure(const StatsOptions& options) {
  const TemporaryFolder folder(
      options.disk.empty() ? fs::temp_directory_path() : fs::path(options.disk));
  std::fprintf(
      stderr,
      "making a synthetic study of %lld answers\n",
      static_cast<long long>(options.answers));
  const auto made = makeSyntheticStudy(folder.path(), options.answers);
  StatsMeasurement measured{.sessions = made.sessions};
  measured.databaseSize = static_cast<double>(fs::file_size(made.folder / "study.db")) / 1e6;
  resetPeakMemory();
  measured.memoryBefore = peakMemory();
  for (int i = 0; i < options.repetitions; ++i) {
    const auto start = std::chrono::steady_clock::now();
    measured.counted = compareAll(made.folder);
    measured.seconds.push_back(haptics::timing::secondsSince(start));
  }
  measured.memory = peakMemory();
  return measured;
}

DataTable timeTable(const StatsMeasurement& measured) {
  const auto& seconds = measured.seconds;
  return {
      .name = "times",
      .description = "From the database to the table [ms]",
      .columns =
          {{"times", "Times"}, {"first_ms", "First"}, {"p50_ms", "Median"}, {"p99_ms", "p99"}},
      .rows = {
          {static_cast<std::int64_t>(seconds.size()),
           1e3 * seconds.front(),
           1e3 * quantile(seconds, 0.5),
           1e3 * quantile(seconds, 0.99)}}};
}

DataTable sizeTable(const StatsMeasurement& measured, std::int64_t answers) {
  return {
      .name = "sizes",
      .description = "SYNTHETIC: made-up answers of simulated participants",
      .columns =
          {{"answers", "Answers"},
           {"counted", "… in the table"},
           {"participants", "Participants"},
           {"database_mb", "Database [MB]"},
           {"memory_before_mb", "Memory before [MB]"},
           {"memory_mb", "… at most [MB]"}},
      .rows = {
          {answers,
           static_cast<std::int64_t>(measured.counted),
           measured.sessions,
           measured.databaseSize,
           measured.memoryBefore,
           measured.memory}}};
}

int stats(const StatsOptions& options) {
  const auto measured = measure(options);
  printAndWrite(
      options.out,
      "stats",
      {.title = "From answers to the table: how fast",
       .lead = {"From opening a study to all declared comparisons by Welch's test. The study was "
                "made for this and is removed again. docs/benchmarks.md explains the columns."},
       .parts = {
           {.heading = "Times",
            .tables = {sizeTable(measured, options.answers), timeTable(measured)}}}});
  const bool areAllCounted = measured.counted == static_cast<std::uint64_t>(options.answers);
  if (!areAllCounted) fmt::print("FAIL  the table does not hold every answer.\n");
  return areAllCounted ? 0 : 1;
}

}  // namespace

void addStatsCommand(CLI::App& program, Action& action) {
  auto [command, options] = app::addCommand(
      program,
      action,
      "stats",
      "Measure time and memory of computing the table of comparisons from a database of answers",
      stats);
  addOutFolder(*command, options.out, "tables (CSV)");
  command->add_option("--answers", options.answers, "Number of answers in the synthetic study")
      ->check(CLI::Range(std::int64_t{100}, std::int64_t{100'000'000}))
      ->capture_default_str();
  command
      ->add_option(
          "--repetitions", options.repetitions, "Number of times that the table is computed")
      ->check(CLI::Range(1, 10'000))
      ->capture_default_str();
  command
      ->add_option(
          "--disk", options.disk, "Folder for the database (default: that of temporary files)")
      ->check(CLI::ExistingDirectory);
}

}  // namespace study::bench
