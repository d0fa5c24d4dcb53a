#pragma once

#include <cstdint>
#include <filesystem>

#include "study/model/progress.h"
#include "study/session/verification.h"

namespace study {

/// What a copy of a study came to.
struct Backup {
  std::uintmax_t bytes = 0;   ///< of all its files
  Verification verification;  ///< of the copy; as sound as the study is
};

/// Copies a study's folder to @p destination, which does not exist yet, all or nothing, and reads
/// the copy to its last byte. Sessions may be open meanwhile: all three databases are copied as
/// they were at one moment at which nothing was being written. Exports and the device file come
/// with them; the room that is kept free does not.
/// @throws storage::StorageError  if the study cannot be read, or the copy cannot be written.
/// @throws whatever @p progress throws; then there is no copy.
Backup backUp(
    const std::filesystem::path& folder,
    const std::filesystem::path& destination,
    const Progress& progress = {});

}  // namespace study
