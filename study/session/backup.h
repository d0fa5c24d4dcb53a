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
  return questionnaires::utf8CharacterCount(text) ? text : "a folder whose name is not UTF-8";
}

/// The result of copying a study.
struct Backup {
  std::uintmax_t bytes = 0;   ///< of all its files
  Verification verification;  ///< of the copy; a problem of the copy is a problem of the study, too
  bool isNoted = true;        ///< false if the study cannot be written (kCopyNotNoted)
};

/// Copies a study's folder to @p destination, which must not exist yet, and verifies the whole
/// copy. If anything fails, no copy is left. Sessions may be open meanwhile: all three databases
/// are copied in the state of one moment at which nothing was being written. Exports and the device
/// file are copied, too; the reserved disk space is not.
/// @throws storage::StorageError  if the study cannot be read, or the copy cannot be written.
/// @throws any exception of @p progress; then there is no copy.
Backup backUp(
    const std::filesystem::path& folder,
    const std::filesystem::path& destination,
    const Progress& progress = {});

/// The number of heads that this station signed, but that the study's trail neither contains nor
/// lists as given up. It is more than 0 if the study is an older copy, if the end of its trail was
/// cut off, or if its trail has another first event.
/// @throws storage::StorageError
std::size_t headsMissingIn(Study& study);

/// Notes in the trail that an older copy (a backup) or a copy from elsewhere replaced the study.
/// The event lists the missing heads as given up, so that verify() no longer reports a cut-off end;
/// this station signs the trail again. Does nothing if no head is missing.
/// @return the number of heads that were given up
/// @throws storage::StorageError  if the station's list cannot be read or the study cannot be
///     written
std::size_t recordRestoredCopy(Study& study, const std::string& reason);

}  // namespace study
