#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/model/ids.h"
#include "study/storage/database.h"

namespace study::storage {

/// Deletes the rows of a session that hold what a person did: answers, trials, cuts, visits, the
/// lease. The session itself and its order stay, with the state `erased` and without the reason for
/// its end; its place is free again. Inside the caller's transaction.
/// @return  how many answers there were
std::int64_t eraseAnswers(Database& study, SessionId session, const std::string& utc);

/// Deletes the traces of sessions. One transaction.
void eraseTraces(Database& traces, const std::vector<SessionId>& sessions);

/// What was written about a participant in words: answers, reasons. Not what others have as well.
std::vector<std::string> textsAbout(const Database& study, const std::string& participant);

/// Whether the audit trail says something of a session that is not sealed: an older release wrote
/// it.
bool hasUnsealedEvents(const Database& study, SessionId session);

/// Takes what was deleted out of the file: moves the write-ahead log into it, builds it anew
/// without its free pages, and empties the log.
/// @throws StorageError  (Busy) while another program reads the file
void purge(Database& database);

}  // namespace study::storage
