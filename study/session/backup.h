#pragma once

#include <cstdint>
#include <filesystem>

#include "study/model/progress.h"
#include "study/session/verification.h"

namespace study {

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

}  // namespace study
