#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "study/bench/collect/many_stations.h"

namespace study::bench {

/// The options of measureCollection().
struct CollectBenchOptions {
  std::filesystem::path folder;  ///< of the stations' folders and the pulled study; temporary
  std::int64_t answers = 1'000'000;
  int sites = 1000;
  int participants = 200;  ///< participants of the station that sends samples
  int repetitions = 21;    ///< number of repetitions of each timed query
};

/// Times of ingesting the data of some of the stations, and of a plain COPY of the same rows.
struct IngestSpeed {
  std::int64_t before = 0;  ///< answers in the database before this part
  StationPush sent;         ///< of all stations of the part
  WorkTime copying;         ///< COPY of their answers into a table without keys
  WorkTime copyingAll;      ///< COPY of all their rows, including events and sessions
};

/// Times of two ways to compute equal counts [s], measured alternately.
struct AlternatedTimes {
  std::vector<double> ours;  ///< from the analyst's view
  std::vector<double> bare;  ///< from a plain table
};

/// The size of a table of the server.
struct TableSize {
  std::string table;
  std::int64_t rows = 0;
  std::int64_t bytes = 0;    ///< size with TOAST, without indexes [B]
  std::int64_t indexes = 0;  ///< size of the indexes [B]
};

/// The results of measureCollection().
struct CollectMeasurement {
  std::int64_t answers = 0;
  int sites = 0;
  std::int64_t sessions = 0;
  std::int64_t events = 0;
  std::vector<IngestSpeed> parts;  ///< one after another, with a growing table
  StationPush recorded;            ///< the station with samples
  std::vector<WorkTime> copyingTraces;
  AlternatedTimes counts;  ///< from the analyst's view, and from a plain table of the same rows
  std::size_t groups = 0;
  WorkTime pulling;
  double memoryBefore = 0.0;   ///< [MB]
  double memory = 0.0;         ///< largest while pulling [MB]
  double pulledMegabytes = 0;  ///< size of the pulled folder [MB]
  std::vector<TableSize> tables;
  std::vector<std::string> plan;      ///< EXPLAIN ANALYZE of the counts from the view
  std::vector<std::string> problems;  ///< differences from the sent data, on the server or in the
                                      ///< pulled study; empty if there are none
};

/// Starts a private PostgreSQL server and measures on it.
/// @throws UserError  if PostgreSQL is not installed
CollectMeasurement measureCollection(const CollectBenchOptions& size);

}  // namespace study::bench
