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
  /// The earliest of the last events of those sessions of real participants that have not arrived
  /// [UTC]; empty if there are none. The times of simulated sessions are virtual.
  std::string waitingSince;
};

/// The arrivals at a server that has all events up to number @p event.
Arrivals arrivalsBy(Study& study, std::int64_t event);

/// The result of the last push of a study to its server. It is stored outside the study, for this
/// user of the computer, so that the operator's windows can show it without a network.
struct PushRecord {
  std::string utc;             ///< of the push; empty: there was none
  std::int64_t lastEvent = 0;  ///< number of events that the server had after the push
  std::string problem;         ///< name of the refusal or kind of error; empty: it succeeded
};

/// @param study, station  their uuids
PushRecord lastPush(const std::string& study, const std::string& station);
/// Appends the result to the account's list. Does nothing if the list cannot be written: the next
/// push asks the server for its state anyway.
void recordPush(
    const std::string& study, const std::string& station, const PushRecord& push) noexcept;

/// The confirmation by the server that it, too, has erased a session.
struct ErasureReceipt {
  std::int64_t session = 0;
  std::string participant;
  std::string utc;        ///< when the server erased it
  std::int64_t left = 0;  ///< answers, samples and keys that the server still has
};

/// Adds a receipt to the account's list, unless it is there. Does nothing if the list cannot be
/// written.
void recordErasureReceipt(
    const std::string& study, const std::string& station, const ErasureReceipt& receipt) noexcept;
/// The receipts in the account's list, the last of each session.
std::vector<ErasureReceipt> receiptsOf(const std::string& study, const std::string& station);

}  // namespace study
