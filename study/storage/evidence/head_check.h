#pragma once

#include <string>
#include <vector>

#include "study/storage/evidence/findings.h"
#include "study/storage/evidence/station_heads.h"
#include "study/storage/evidence/trail_heads.h"

namespace study::storage {

/// Checks that a trail has all events up to each head that was noted outside of the study.
/// @param isOlderCopy  the trail is known to be an older copy: heads that were noted after its end
///     may be missing
Findings checkHeads(
    const TrailHeads& trail, const std::vector<NotedHead>& noted, bool isOlderCopy = false);

/// checkHeads() with the heads that this station noted. If the station noted heads of a study with
/// this uuid, and the first of them has another first event, the trail is reported as a different
/// one, even if the station signed it later.
/// @throws StorageError  if the station's list cannot be read
Findings checkStation(const TrailHeads& trail, const StationStore& station, bool isOlderCopy);

/// The heads that this station noted and that the trail neither contains nor lists as given up. All
/// of them if the station's list begins with another trail. A station signs a trail only if no head
/// is missing.
/// @throws StorageError  if the station's list cannot be read
std::vector<SignedHead> missingHeads(const TrailHeads& trail, const StationStore& station);

}  // namespace study::storage
