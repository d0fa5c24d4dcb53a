#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "study/bench/collect/many_stations.h"

namespace study::bench {

struct CollectSize {
  std::filesystem::path folder;  ///< for the stations' folders and the pulled study
  std::int64_t answers = 1'000'000;
  int sites = 1000;
  int participants = 200;  ///< of the station with samples
  int repetitions = 21;    ///< of each timed query
};

/// Times of ingesting the data of one part of the stations, and of a plain COPY of the same rows.
struct IngestSpeed {
  std::int64_t before = 0;  ///< answers in the database before this part
  StationPush sent;         ///< of all stations of the part
  double copying = 0.0;     ///< COPY of their answers into a table without keys [s]
  double copyingAll = 0.0;  ///< … of all their rows, events and sessions included [s]
};

/// Times of two ways to compute the same counts [s], measured alternately.
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
  AlternatedTimes counts;  ///< from the analyst's view, and from a plain table of the same rows
  std::size_t groups = 0;
  double pulling = 0.0;        ///< [s]
  double memoryBefore = 0.0;   ///< [MB]
  double memory = 0.0;         ///< largest while pulling [MB]
  double pulledMegabytes = 0;  ///< size of the pulled folder [MB]
  std::vector<TableSize> tables;
  std::vector<std::string> plan;      ///< EXPLAIN ANALYZE of the counts in the view
  std::vector<std::string> problems;  ///< differences from what was sent; empty: all arrived
};

/// Starts a private PostgreSQL server and measures on it. @throws UserError  if PostgreSQL is not
/// installed
CollectMeasurement measureCollection(const CollectSize& size);

}  // namespace study::bench
