#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/model/ids.h"
#include "study/storage/database.h"

namespace study::storage {

/// How far the audit trail speaks of a session.
struct SessionMark {
  SessionId session{};
  std::string participant;  ///< code
  std::int64_t lastEvent = 0;
  std::string utc;  ///< of that event
};

/// Of all sessions, in the order of their numbers.
std::vector<SessionMark> sessionMarks(const Database& study);

}  // namespace study::storage
