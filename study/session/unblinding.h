#pragma once

#include <string>

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

/// How a study must be opened for noteUnblinding().
inline storage::Database::Access accessToNote(const std::string& reason) {
  return reason.empty() ? storage::Database::Access::ReadOnly
                        : storage::Database::Access::ReadWrite;
}

}  // namespace study
