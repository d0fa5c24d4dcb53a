#pragma once

#include <string>
#include <vector>

#include "study/storage/event_log.h"

namespace study::collect {

/// What is wrong with the audit trail of a station, as the server has it: a hash that is not of its
/// event, a signature that is not of the events before it, or of another key than the station's.
/// Empty: nothing.
/// @param key  the station's public key, as it was enrolled
std::vector<std::string> problemsIn(
    const std::vector<storage::StoredEvent>& trail,
    const std::string& study,
    const std::string& key);

}  // namespace study::collect
