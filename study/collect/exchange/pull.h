#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "study/collect/server/connection.h"
#include "study/model/clock.h"
#include "study/model/progress.h"

namespace study::collect {

struct PullRequest {
  std::string study;  ///< its name; empty: the only one
  std::filesystem::path folder;
  std::string reason;  ///< kept on the server: what is pulled has the map of conditions in it
};

/// What was pulled of one station.
struct PulledStation {
  std::string label;
  std::int64_t events = 0;
  std::size_t sessions = 0;
  std::size_t erased = 0;
  std::uint64_t traceBytes = 0;
  /// Sessions that were left out because their last events have arrived and their rows have not:
  /// the station was interrupted.
  std::vector<std::string> incomplete;
  /// What is not as the station signed it. Sessions that it is of were left out, and named.
  std::vector<std::string> problems;
};

/// What was pulled.
struct PullResult {
  std::vector<PulledStation> stations;
  std::vector<std::string> problems;  ///< that 'study verify' finds in the folder

  bool isSound() const noexcept;
  std::size_t sessions() const noexcept;
};

/// Makes an ordinary study of all that has arrived, as it is on the server at one moment, and
/// verifies it. Each station's audit trail is computed again and its signatures are checked, and
/// all rows and samples are compared with the hashes that the trail has of them (StationTrail).
/// What a station did not sign is left out and named; the other stations are not stopped by it.
/// @throws ServerError
/// @throws UserError  if the study is unknown, or there is no reason
/// @throws storage::StorageError  (Damaged) if seed or protocols on the server are damaged
PullResult pull(
    Connection& server, const PullRequest& request, Clock& clock, const Progress& progress = {});

}  // namespace study::collect
