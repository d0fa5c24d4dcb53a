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

/// A folder as an event of the audit trail names it. A name that is no UTF-8 cannot be stored.
inline std::string pathForAuditTrail(const std::filesystem::path& folder) {
  std::error_code ignored;
  auto text = std::filesystem::absolute(folder, ignored).lexically_normal().string();
  return questionnaires::charactersIn(text) ? text : "a folder whose name is not UTF-8";
}

/// The result of copying a study.
struct Backup {
  std::uintmax_t bytes = 0;   ///< of all its files
  Verification verification;  ///< of the copy; it finds the same problems as in the study itself
};

/// Copies a study's folder to @p destination, which must not exist yet, and reads the copy to its
/// last byte. If anything fails, no copy is left. Sessions may be open meanwhile: all three
/// databases are copied as they were at one moment at which nothing was being written. Exports and
/// the device file are copied, too; the reserved disk space is not.
/// @throws storage::StorageError  if the study cannot be read, or the copy cannot be written.
/// @throws whatever @p progress throws; then there is no copy.
Backup backUp(
    const std::filesystem::path& folder,
    const std::filesystem::path& destination,
    const Progress& progress = {});

/// How many heads that this station signed a study neither has nor gave up: more than none of an
/// older copy that took its place, of one whose end was cut off, and of one with another beginning.
/// @throws storage::StorageError
std::size_t headsMissingIn(Study& study);

/// Notes that an older copy, a backup, took the place of a study, or the same study from elsewhere:
/// what this station signed of the other is given up, and verify() no longer takes it for an end
/// that was cut off. Until then this station signs nothing of it. Nothing is noted if nothing is
/// missing.
/// @return how many signed heads were given up
/// @throws storage::StorageError  if the station's list cannot be read, or the study not be written
std::size_t noteRestoredCopy(Study& study, const std::string& reason);

}  // namespace study
