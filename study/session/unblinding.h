#pragma once

#include <string>

#include "study/model/run_mode.h"
#include "study/session/study.h"
#include "study/storage/database.h"

namespace study {

/// Results that name conditions unblind whoever reads them, where real people took part: that is
/// written into the audit trail with its reason, before anything is shown. Of pilots and simulated
/// sessions it takes no reason, and nothing is written: nobody was blind.
/// @param what  is shown: "report", "results"; the event is "unblinded_report"
/// @throws storage::StorageError  in words, of live sessions without a reason.
void noteUnblinding(Study& study, RunMode mode, const std::string& what, const std::string& reason);

/// What a study has to be opened for, so that it can be noted.
inline storage::Database::Access accessToNote(const std::string& reason) {
  return reason.empty() ? storage::Database::Access::ReadOnly
                        : storage::Database::Access::ReadWrite;
}

}  // namespace study
