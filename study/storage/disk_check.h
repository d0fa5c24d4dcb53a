#pragma once

#include <filesystem>

namespace study::storage {

/// How long an answer takes to be safe on the disk.
struct CommitTimes {
  int commits = 0;
  double median = 0.0;   ///< [s]
  double longest = 0.0;  ///< [s]
};

/// Commits @p commits small rows, each as an answer is committed (write-ahead log,
/// synchronous=FULL), to a file of its own in @p folder, which is gone again afterwards.
/// @throws StorageError  if the folder cannot be written.
CommitTimes measureCommits(const std::filesystem::path& folder, int commits);

}  // namespace study::storage
