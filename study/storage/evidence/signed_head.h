#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/message.h"
#include "study/storage/database.h"
#include "study/storage/station_store.h"

namespace study::storage {

/// A station's signed statement about an audit trail: the number of its events, and the hash of the
/// last one. An event's hash depends on all events before it, so the signature covers all of them
/// (docs/decisions/0041).
struct SignedHead {
  std::string study;           ///< uuid
  std::string first;           ///< hash of the first event: distinguishes trails of one uuid
  std::int64_t events = 0;     ///< number of events
  std::string hash;            ///< hash of the last event
  std::string utc;             ///< time of signing
  std::string purpose;         ///< name of the event kind that caused the signature, or kWitness
  std::string key = {};        ///< the station's public key
  std::string signature = {};  ///< of the members above, with `key`

  bool isSigned() const;

  /// One line of text without leading or trailing spaces, for a station's list and for files.
  std::string asLine() const;

  /// The values of an event SignedHead. Study and first event are left out, because the trail that
  /// contains the event has them.
  base::NamedArguments asValues() const;
};

/// Purpose of a head that is signed for a witness file only, without an event in the trail.
inline constexpr std::string_view kWitness = "witness";

/// Parses a line of asLine(); std::nullopt for other text. @p rest receives the text after the
/// head.
std::optional<SignedHead> headIn(const std::string& line, std::string* rest = nullptr);

/// The end of an audit trail.
struct TrailEnd {
  std::int64_t events = 0;  ///< number of events
  std::string hash;         ///< hash of the last event; empty before the first
};
/// The end of the trail in study.db.
TrailEnd endOf(const Database& study);

/// Signs the last event of the audit trail, which must not be empty.
SignedHead signHead(
    const Database& study, const StationStore& station, std::string_view purpose, std::string utc);

/// The first 128 bits of a hash in eight groups, to be read aloud: "1a2b 3c4d …".
std::string inGroupsOfFour(const std::string& hash);

}  // namespace study::storage
