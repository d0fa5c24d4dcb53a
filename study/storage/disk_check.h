#pragma once

#include <filesystem>

namespace study::storage {

/// How long it takes to commit an answer to the disk.
struct CommitTimes {
  int commits = 0;
  double median = 0.0;   ///< [s]
  double longest = 0.0;  ///< [s]
};

/// Commits @p commits small rows in the way answers are committed (write-ahead log,
/// synchronous=FULL), to a new file in @p folder that is removed afterwards.
/// @throws StorageError  if the folder cannot be written.
CommitTimes measureCommits(const std::filesystem::path& folder, int commits);

}  // namespace study::storage
