#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>

#include "questionnaires/json/document.h"
#include "study/model/progress.h"
#include "study/session/study.h"
#include "study/session/verification.h"

namespace study {

/// The absolute path of @p folder, for an event of the audit trail. A path that is not valid UTF-8
/// cannot be stored and is replaced.
inline std::string pathForAuditTrail(const std::filesystem::path& folder) {
  std::error_code ignored;
  auto text = std::filesystem::absolute(folder, ignored).lexically_normal().string();
  return questionnaires::charactersIn(text) ? text : "a folder whose name is not UTF-8";
}

/// The result of copying a study.
struct Backup {
  std::uintmax_t bytes = 0;   ///< of all its files
  Verification verification;  ///< of the copy; the study itself has the same problems
};

/// Copies a study's folder to @p destination, which must not exist yet, and reads the copy to its
/// last byte. If anything fails, no copy is left. Sessions may be open meanwhile: all three
/// databases are copied in the state of one moment at which nothing was being written. Exports and
/// the device file are copied, too; the reserved disk space is not.
/// @throws storage::StorageError  if the study cannot be read, or the copy cannot be written.
/// @throws whatever @p progress throws; then there is no copy.
Backup backUp(
    const std::filesystem::path& folder,
    const std::filesystem::path& destination,
    const Progress& progress = {});

/// The number of heads that this station signed and that the study's trail neither contains nor
/// lists as given up. More than 0 if the study is an older copy, if its end was cut off, or if it
/// has another beginning.
/// @throws storage::StorageError
std::size_t headsMissingIn(Study& study);

/// Notes in the trail that the study was replaced by an older copy (a backup) or by a copy from
/// elsewhere. The missing heads are listed as given up, so that verify() no longer reports a
/// cut-off end, and this station signs the trail again. Does nothing if no head is missing.
/// @return the number of heads that were given up
/// @throws storage::StorageError  if the station's list cannot be read, or the study not be written
std::size_t noteRestoredCopy(Study& study, const std::string& reason);

}  // namespace study
