#pragma once

#include <string>
#include <vector>

#include "study/storage/evidence/findings.h"
#include "study/storage/evidence/station_heads.h"
#include "study/storage/evidence/trail_heads.h"

namespace study::storage {

/// Whether a trail goes on from heads that were noted outside of it.
/// @param isOlderCopy  the trail is said to be an older copy: what was noted later may be missing
Findings checkHeads(
    const TrailHeads& trail, const std::vector<NotedHead>& noted, bool isOlderCopy = false);

/// The same with what this station noted. A study whose beginning it does not know, although it
/// signed others of the same uuid, is not accepted, however often it was signed later.
/// @throws StorageError  if the station's list cannot be read
Findings checkStation(const TrailHeads& trail, const StationStore& station, bool isOlderCopy);

/// The heads that this station noted and the trail neither has nor gave up. All of them, if it does
/// not know the trail's beginning. A station signs only a trail that lacks none.
/// @throws StorageError  if the station's list cannot be read
std::vector<SignedHead> missingHeads(const TrailHeads& trail, const StationStore& station);

}  // namespace study::storage
