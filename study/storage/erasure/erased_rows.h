#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/model/ids.h"
#include "study/storage/database.h"

namespace study::storage {

/// Deletes what a participant did in a session: answers, trials, cuts, visits, and the lease. The
/// session and its order are kept, with the state `erased` and without the reason for its end; its
/// place in the design is released. Inside the caller's transaction.
/// @return  the number of deleted answers
std::int64_t eraseAnswers(Database& study, SessionId session, const std::string& utc);

/// Deletes the traces of sessions in one transaction.
void eraseTraces(Database& traces, const std::vector<SessionId>& sessions);

/// The free texts by or about a participant: answers, reasons of visits and sessions. Texts that
/// rows of other participants also contain are left out.
std::vector<std::string> textsAbout(const Database& study, const std::string& participant);

/// Whether the audit trail has unsealed events of a session, which an older release wrote.
bool hasUnsealedEvents(const Database& study, SessionId session);

/// Deletes the remains of deleted rows from the file: checkpoints the write-ahead log, rebuilds the
/// file without free pages (VACUUM), and empties the log.
/// @throws StorageError  (Busy) while another program reads the file
void purge(Database& database);

}  // namespace study::storage
