#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "study/storage/evidence/signed_head.h"

namespace study::storage {

/// A head that a station signed, and the folder of the study at that time.
struct RecordedHead {
  SignedHead head;
  std::string folder;
};

/// Appends a head to the station's list of the study. The list is on the disk on return.
/// @throws StorageError
void recordHead(
    const StationStore& station, const SignedHead& head, const std::filesystem::path& folder);

/// The heads in a station's list of a study.
struct RecordedHeads {
  std::vector<RecordedHead> heads = {};  ///< oldest first
  /// Number of lines without a valid signature of this station: changed, or cut off by a full disk.
  std::size_t unsoundLines = 0;
};

/// @throws StorageError  if the list cannot be read
RecordedHeads readRecordedHeads(const StationStore& station, const std::string& study);

}  // namespace study::storage
