#include <cstdio>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "study/app/commands.h"
#include "study/app/write_document.h"
#include "study/bench/bench_stats.h"

namespace study::app {
namespace {

struct StatsOptions {
  std::string out;
  bool json = false;
  StatsBenchOptions bench;
  std::string worker;  ///< which part another process asks for; empty where a person asks
  std::string study;
};

void printTimes(const char* what, const std::vector<double>& seconds) {
  fmt::print(
      "{:<34} {:>12.3f} ms (median), {:>12.3f} (p99 of {})\n",
      what,
      1e3 * quantileOf(seconds, 0.5),
      1e3 * quantileOf(seconds, 0.99),
      seconds.size());
}

void printStats(const StatsMeasurement& measured) {
  fmt::print(
      "SYNTHETIC: {} answers of {} people who do not exist; a database of {:.0f} MB\n",
      measured.answers,
      measured.sessions,
      measured.databaseSize);
  printTimes("database to table", measured.ours.seconds);
  printTimes("… of that, a processor was busy", measured.processor);
  printTimes("one answer changed, new table", measured.edits);
  printTimes("the change itself, on the disk", measured.writing);
  fmt::print(
      "memory at most {:.1f} MB, of them {:.1f} before the study was opened\n",
      measured.memory,
      measured.memoryBefore);
  for (const auto& peer : measured.peers) {
    if (peer.seconds.empty()) {
      fmt::print("{}: not measured, {}\n", peer.way, peer.absence);
      continue;
    }
    printTimes(peer.way.c_str(), peer.seconds);
    fmt::print(
        "    {}; largest difference to ours {:.2g}\n",
        peer.version,
        largestDifference(measured.ours.rows, peer.rows));
  }
}

int benchStats(const StatsOptions& options) {
  if (!options.worker.empty()) {
    return measureStatsPart(options.study, options.worker, options.bench.repetitions);
  }
  const auto measured = measureStats(options.bench);
  if (options.json) {
    std::fputs(statsAsJson(measured).c_str(), stdout);
  } else {
    printStats(measured);
    printTargets(statsTargets(measured));
  }
  if (!options.out.empty()) writeDocument(options.out, "stats", statsReport(measured));
  return measured.isSameAfterEdits ? 0 : 1;
}

}  // namespace

void addStatsBench(CLI::App& bench, Action& action) {
  auto options = std::make_shared<StatsOptions>();
  auto& wanted = options->bench;
  auto* verb = bench.add_subcommand(
      "stats", "From a database of answers to the table of comparisons, beside R and pandas");
  verb->add_option("--out", options->out, "A folder for tables (CSV) and a page");
  verb->add_option("--answers", wanted.answers, "Of a synthetic study that is made for this")
      ->check(CLI::Range(std::int64_t{100}, std::int64_t{100'000'000}))
      ->capture_default_str();
  verb->add_option("--repetitions", wanted.repetitions, "How often the table is made")
      ->check(CLI::Range(1, 10'000))
      ->capture_default_str();
  verb->add_option("--edits", wanted.edits, "How many answers are changed, one by one")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  verb->add_flag("--peers", wanted.withPeers, "R's data.table and Python's pandas, if installed");
  verb->add_option("--disk", wanted.disk, "A folder for the database (default: temporary files)")
      ->check(CLI::ExistingDirectory);
  verb->add_flag("--json", options->json, "For programs, full precision");
  verb->add_option("--worker", options->worker)->group("");  // not for people
  verb->add_option("--study", options->study)->group("");
  verb->callback([&action, options] { action = [options] { return benchStats(*options); }; });
}

}  // namespace study::app
