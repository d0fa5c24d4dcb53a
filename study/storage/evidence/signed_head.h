#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/message.h"
#include "study/storage/database.h"
#include "study/storage/station_store.h"

namespace study::storage {

/// What a station says of an audit trail, with its signature: that it had so many events, and which
/// hash the last of them had. An event's hash depends on all events before it, so that this vouches
/// for everything up to there (docs/decisions/0041).
struct SignedHead {
  std::string study;        ///< uuid
  std::string first;        ///< hash of the first event: tells studies of one uuid apart
  std::int64_t events = 0;  ///< how many there were
  std::string hash;         ///< of the last of them
  std::string utc;          ///< when it was signed
  std::string purpose;      ///< name of the event kind that it was signed for, or kWitness
  std::string key = {};     ///< the station's public key
  std::string signature = {};

  bool isSigned() const;

  /// One line without spaces at its ends, for a station's list and for files.
  std::string asLine() const;

  /// Values of an event SignedHead. Study and first event are those of the trail that holds it.
  base::NamedArguments asValues() const;
};

/// Purpose of a head that was signed for a file alone: no event of the trail says so.
inline constexpr std::string_view kWitness = "witness";

/// What asLine() wrote; std::nullopt for other text. Text behind it is given in @p rest.
std::optional<SignedHead> headIn(const std::string& line, std::string* rest = nullptr);

/// Where an audit trail ends now.
struct TrailEnd {
  std::int64_t events = 0;
  std::string hash;  ///< of the last one; empty before the first
};
TrailEnd endOf(const Database& study);

/// Signs what the audit trail holds now. The trail has an event.
SignedHead signHead(
    const Database& study, const StationStore& station, std::string_view purpose, std::string utc);

/// The first 128 bits of a hash in eight groups, to be read aloud: "1a2b 3c4d …".
std::string inGroupsOfFour(const std::string& hash);

}  // namespace study::storage
