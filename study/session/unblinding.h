#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "study/model/run_mode.h"
#include "study/session/study.h"
#include "study/storage/database.h"
#include "study/storage/event_log.h"

namespace study {

/// Results that name conditions unblind the reader. For live and pilot sessions the reason is
/// appended to the audit trail before the results are shown. Studies whose protocol has no blinding
/// need no reason; without one nothing is appended. For simulated sessions nothing is appended.
/// @param kind  UnblindedReport or UnblindedResults
/// @throws storage::StorageError  if results of live or pilot sessions are requested without a
///     reason.
void recordUnblinding(Study& study, RunMode mode, EventKind kind, const std::string& reason);

/// Notes a copy of the data in the audit trail, so that knownCopies() lists it for an erasure.
/// @return  false if the study cannot be written (a full disk, an archive), which must not prevent
///     a copy that may rescue the data: the caller says kCopyNotNoted
/// @throws storage::StorageError  (Busy) if another program writes to the study for too long.
bool noteCopy(Study& study, const storage::Event& event);

/// The message about a copy that could not be noted in the audit trail.
extern const std::string_view kCopyNotNoted;

/// Notes in the audit trail where a report or its figures will be written. They contain answers and
/// texts of participants, so knownCopies() lists them for an erasure. Nothing is noted for
/// simulated sessions.
/// @param how  "report" or "figures"
/// @param content  of the file, for its fingerprint: an erasure deletes a file only if it has this
///     content; empty: @p path is a folder
/// @return  as noteCopy()
bool recordReportPath(
    Study& study,
    RunMode mode,
    const std::string& how,
    const std::filesystem::path& path,
    std::string_view content = {});

/// Notes in the audit trail that a copy of a participant's consent form will be written, so that
/// copiesNotErased() lists it for their erasure. Where it is written is not noted: the name of a
/// file may name a person, and the trail is never deleted.
/// @return  as noteCopy()
bool recordConsentCopy(Study& study, const std::string& participant);

/// Notes in the audit trail that @p names of participants are shown, so that it can be told later
/// when they were seen. Does nothing if there are none.
/// @return  as noteCopy()
bool recordNamesShown(Study& study, std::size_t names);

/// The message about names whose showing could not be noted in the audit trail.
extern const std::string_view kNamesNotNoted;

/// A hash of a file that the program writes; keyed with the study's key if conditions are sealed.
/// With an unkeyed hash, readers of the audit trail could compute the report for each possible
/// order and recognise the true one.
std::string fingerprintOf(Study& study, std::string_view content);

/// The access that recordUnblinding() needs: to write if there is a reason.
inline storage::Database::Access accessForUnblinding(const std::string& reason) {
  return reason.empty() ? storage::Database::Access::ReadOnly
                        : storage::Database::Access::ReadWrite;
}

}  // namespace study
