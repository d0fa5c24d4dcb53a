#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "study/bench/collect/many_stations.h"

namespace study::bench {

struct CollectSize {
  std::filesystem::path folder;  ///< for the stations' folders and the one that is pulled
  std::int64_t answers = 1'000'000;
  int sites = 1000;
  int participants = 200;  ///< with samples
  int repetitions = 21;    ///< of what is timed in turn
};

/// Ingest beside COPY of the same rows, of one part of the stations.
struct IngestSpeed {
  std::int64_t before = 0;  ///< answers that were there already
  StationPush sent;         ///< of all stations of the part
  double copying = 0.0;     ///< COPY of their answers into a table without keys [s]
  double copyingAll = 0.0;  ///< … of all their rows, events and sessions included [s]
};

/// Times of two ways to do the same [s], taken in turn.
struct AlternatedTimes {
  std::vector<double> ours;
  std::vector<double> bare;
};

struct TableSize {
  std::string table;
  std::int64_t rows = 0;
  std::int64_t bytes = 0;    ///< with TOAST, without indexes
  std::int64_t indexes = 0;  ///< [B]
};

struct CollectMeasurement {
  std::int64_t answers = 0;
  int sites = 0;
  std::int64_t sessions = 0;
  std::int64_t events = 0;
  std::vector<IngestSpeed> parts;  ///< one after another, with a growing table
  StationPush recorded;            ///< the station with samples
  std::vector<double> copyingTraces;
  AlternatedTimes counts;  ///< the analyst's view, and a table of the same rows
  std::size_t groups = 0;
  double pulling = 0.0;        ///< [s]
  double memoryBefore = 0.0;   ///< [MB]
  double memory = 0.0;         ///< at most, while pulling [MB]
  double pulledMegabytes = 0;  ///< size of the folder
  std::vector<TableSize> tables;
  std::vector<std::string> plan;      ///< of the counts in the view, by EXPLAIN ANALYZE
  std::vector<std::string> problems;  ///< counts that differ; empty: everything arrived
};

/// Starts a private server, and measures on it. @throws UserError  if PostgreSQL is not installed
CollectMeasurement measureCollection(const CollectSize& size);

}  // namespace study::bench
