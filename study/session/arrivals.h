#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/session/study.h"

namespace study {

/// How many sessions a station has, and how many of them have arrived at the server of its study.
struct Arrivals {
  std::int64_t all = 0;
  std::int64_t arrived = 0;
  /// Since when the oldest that did not arrive waits: its last event; empty: none waits.
  std::string waitingSince;
};

/// Of a server that has all events up to @p event.
Arrivals arrivalsBy(Study& study, std::int64_t event);

/// What this account noted of its last push of a study, so that the desk can tell without a
/// network.
struct NotedPush {
  std::string utc;  ///< empty: it never pushed
  std::int64_t have = 0;
  std::string problem;  ///< why it did not succeed: the name of a refusal, or of a kind of problem;
                        ///< empty: it did
};

/// @param study, station  their uuids
NotedPush lastPush(const std::string& study, const std::string& station);
/// Does nothing if the account's list cannot be written: the server is asked anyway.
void notePush(const std::string& study, const std::string& station, const NotedPush& push) noexcept;

/// What the server says of a session that this station erased.
struct ErasureReceipt {
  std::int64_t session = 0;
  std::string participant;
  std::string utc;        ///< when it was erased there
  std::int64_t left = 0;  ///< answers, samples and keys that are there all the same
};

/// Keeps a receipt in the account, once. Does nothing if the account's list cannot be written.
void noteReceipt(
    const std::string& study, const std::string& station, const ErasureReceipt& receipt) noexcept;
/// All that were kept, the oldest first.
std::vector<ErasureReceipt> receiptsOf(const std::string& study, const std::string& station);

}  // namespace study
