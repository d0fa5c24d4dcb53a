#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include "study/bench/bench_report.h"

namespace study::app {

/// What `palpate bench stats` is to measure.
struct StatsBenchOptions {
  std::int64_t answers = 1'000'000;
  int repetitions = 20;  ///< of database → table
  int edits = 200;
  bool withPeers = false;  ///< R's data.table and Python's pandas, where they are installed
  std::string disk;        ///< a folder for the database; empty: where temporary files go
};

/// One row of the table of results, whoever computed it.
struct TableRow {
  std::string cohort, first, second;
  double mean1 = 0.0, mean2 = 0.0;
  double variance1 = 0.0, variance2 = 0.0;
  double t = 0.0;
  double p = 0.0;  ///< two-sided, not corrected; no number where a peer has none
};

/// One way to the table.
struct TableRun {
  std::string way;              ///< "palpate, from the database"
  std::string version;          ///< of the peer's libraries
  std::string absence;          ///< why it was not measured, and what would help; else empty
  std::vector<double> seconds;  ///< one for each repetition
  std::vector<TableRow> rows;
};

struct StatsMeasurement {
  std::int64_t answers = 0;
  std::int64_t sessions = 0;
  double databaseSize = 0.0;  ///< [MB]
  double making = 0.0;        ///< [s]: of the synthetic study
  TableRun ours;
  std::vector<double> processor;  ///< of that, what our process kept a processor busy [s]
  std::vector<double> edits;      ///< from an answer on the disk to the new table [s]
  std::vector<double> writing;    ///< the answer itself: safe on the disk, vouched for [s]
  bool isSameAfterEdits = false;  ///< as counting everything once more
  double memory = 0.0;            ///< most that our process held, database → table [MB]
  double memoryBefore = 0.0;      ///< … before it opened the study [MB]
  std::vector<TableRun> peers;
};

/// Makes a synthetic study in a temporary folder, measures, and removes it.
/// @throws UserError, storage::StorageError  in words.
StatsMeasurement measureStats(const StatsBenchOptions& options);

/// The part of it that a process of its own does: prints what it measured for whoever started it.
/// @param part  "table" or "edits"
int measureStatsPart(const std::string& folder, const std::string& part, int repetitions);

std::vector<Target> statsTargets(const StatsMeasurement& measured);
report::Document statsReport(const StatsMeasurement& measured);
/// Times in seconds, with every row of the table.
std::string statsAsJson(const StatsMeasurement& measured);

/// The value below which a share @p q of @p values lies; no number where there are none.
double quantileOf(std::vector<double> values, double q);

/// The rest of a line that begins with `row`.
TableRow tableRowIn(std::istream& words);

/// The largest difference between two tables: of means and variances absolute, of t relative.
/// Infinite where they are not of the same comparisons.
double largestDifference(const std::vector<TableRow>& ours, const std::vector<TableRow>& theirs);

/// R and Python at the same answers: from a CSV file, and from the study's database.
/// @param keys  a CSV file of items and their keys
std::vector<TableRun> runPeers(
    const std::string& answers, const std::string& keys, const std::string& database, int times);

}  // namespace study::app
