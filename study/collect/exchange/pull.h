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
  std::string reason;  ///< noted on the server, because the pulled study reveals conditions
};

/// The result for one station.
struct PulledStation {
  std::string label;
  std::int64_t events = 0;
  std::size_t sessions = 0;
  std::size_t erased = 0;
  std::uint64_t traceBytes = 0;
  /// Sessions that were left out because their rows have not arrived with their last events: the
  /// push was interrupted.
  std::vector<std::string> incomplete;
  /// Data that differ from what the station signed. Their sessions were left out; each problem
  /// names its session.
  std::vector<std::string> problems;
};

/// The result of pull().
struct PullResult {
  std::vector<PulledStation> stations;
  std::vector<std::string> problems;  ///< problems that 'study verify' finds in the folder

  bool isSound() const noexcept;
  std::size_t sessions() const noexcept;
};

/// Makes a study folder (CollectedStudy) from all data on the server, in the state of one moment,
/// and verifies it. Recomputes each station's audit trail, checks its signatures, and compares all
/// rows and samples with their hashes in the trail (StationTrail). Data that a station did not sign
/// are left out and reported; other stations are not affected.
/// @throws ServerError
/// @throws UserError  if the study is unknown, or there is no reason
/// @throws storage::StorageError  (Damaged) if secret or protocols on the server are damaged
PullResult pull(
    Connection& server, const PullRequest& request, Clock& clock, const Progress& progress = {});

}  // namespace study::collect
