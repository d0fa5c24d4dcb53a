#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "study/model/run_mode.h"
#include "study/session/study.h"
#include "study/storage/database.h"

namespace study {

/// Results that name conditions unblind the reader. If real people took part, the reason is written
/// to the audit trail before anything is shown, also of pilots, whose conditions are sealed as
/// those of live sessions are. Simulated sessions and studies whose protocol has no blinding need
/// no reason, and nothing is written.
/// @param kind  UnblindedReport or UnblindedResults
/// @throws storage::StorageError  in words, if sessions of people are shown without a reason.
void noteUnblinding(Study& study, RunMode mode, EventKind kind, const std::string& reason);

/// Notes where a report or its figures are written, before they are: they tell what participants
/// answered and wrote, and an erasure lists them (knownCopies()). Of simulated sessions nothing is
/// noted. A study that cannot be written is reported on all the same.
/// @param how  "report" or "figures"
/// @param content  of the file, so that an erasure deletes this one only; empty: it is a folder
void noteReport(
    Study& study,
    RunMode mode,
    const std::string& how,
    const std::filesystem::path& path,
    std::string_view content = {});

/// A hash of a file that the study writes. It is made with the study's key if conditions are
/// sealed: otherwise who has the audit trail and no key could compute the report of each possible
/// order, and know the true one by its hash.
std::string fingerprintOf(Study& study, std::string_view content);

/// How a study must be opened for noteUnblinding().
inline storage::Database::Access accessToNote(const std::string& reason) {
  return reason.empty() ? storage::Database::Access::ReadOnly
                        : storage::Database::Access::ReadWrite;
}

}  // namespace study
