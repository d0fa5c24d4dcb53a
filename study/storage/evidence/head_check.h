#pragma once

#include <vector>

#include "study/storage/evidence/findings.h"
#include "study/storage/evidence/station_heads.h"
#include "study/storage/evidence/trail_heads.h"

namespace study::storage {

/// Checks that a trail contains all events up to each of the noted heads.
/// @param isOlderCopy  whether the study is known to be an older copy: it may then lack heads that
///     were noted after its end
Findings checkHeads(
    const TrailHeads& trail, const std::vector<RecordedHead>& noted, bool isOlderCopy = false);

/// checkHeads() for the heads that this station noted. If the station noted heads of a study with
/// this uuid, and the oldest of them has another first event, a different trail is reported, even
/// if the station signed the present one later; not if this trail began, or was accepted on
/// purpose, at the station.
/// @param listed  the station's list, read before the trail: another program may sign events that
///     came after @p trail was read
/// @throws StorageError  if the station's list cannot be read
Findings checkStation(
    const TrailHeads& trail,
    const StationStore& station,
    const RecordedHeads& listed,
    bool isOlderCopy);

/// The heads that this station noted and that the trail neither contains nor lists as given up; all
/// heads if the station's list begins with a different trail. A station signs a trail only if none
/// is missing.
/// @param listed  the station's list, read before the trail
std::vector<SignedHead> missingHeads(const TrailHeads& trail, const RecordedHeads& listed);

}  // namespace study::storage
