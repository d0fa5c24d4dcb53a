#pragma once

#include <string>

#include "study/model/ids.h"
#include "study/model/run_mode.h"
#include "study/storage/database.h"
#include "study/storage/statement.h"

namespace study::storage {

/// The sessions of a run mode that were completed, one after the other by their number, read from
/// an index that holds nothing else. None is kept.
class CompletedSessions {
 public:
  /// From @p first on. The database outlives it. @throws StorageError
  CompletedSessions(Database& database, RunMode mode, SessionId first = {});

  /// On to the next one; false where there is none. @throws StorageError
  bool next();
  /// On to @p session, or the next one after it; whether it is one of them.
  bool isThere(SessionId session);

  SessionId id() const noexcept { return id_; }
  const std::string& cohort() const noexcept { return cohort_; }

 private:
  Statement select_;
  SessionId id_{};  ///< 0 before the first, which is none
  std::string cohort_;
  bool isAtEnd_ = false;
};

}  // namespace study::storage
