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

/// What was pulled.
struct Pulled {
  std::size_t stations = 0;
  std::size_t sessions = 0;
  std::int64_t events = 0;
  std::size_t erased = 0;
  std::uint64_t traceBytes = 0;
  /// Sessions whose last events have arrived and whose rows have not: their station was
  /// interrupted.
  std::vector<std::string> incomplete;
};

/// Makes an ordinary study of all that has arrived, as it is on the server at one moment. Each
/// station's audit trail is computed again and its signatures are checked, each session and each
/// chunk of samples is compared with its hash.
/// @throws ServerError
/// @throws UserError  if the study is unknown, or there is no reason
/// @throws storage::StorageError  (Damaged) if something on the server is not what a station sent
Pulled pull(
    Connection& server, const PullRequest& request, Clock& clock, const Progress& progress = {});

/// What check() found of one station.
struct StationCheck {
  std::string station;
  std::int64_t events = 0;
  std::size_t sessions = 0;
  std::vector<std::string> problems;
};

/// The same checks without making a study. @throws as pull()
std::vector<StationCheck> check(
    Connection& server, const std::string& study, const std::string& reason);

}  // namespace study::collect
