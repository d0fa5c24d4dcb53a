#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace study::storage {

/// The type of the file system with device number @p device in @p mounts, the text of
/// /proc/self/mountinfo (proc_pid_mountinfo(5)): "ext4", "fuse.sshfs". Empty if it is not there.
std::string fileSystemOf(std::string_view mounts, dev_t device);

/// Whether files of such a file system can be changed from another computer, or are shared with one
/// by a program: NFS, SMB, 9p, Ceph and their kind, and FUSE. SQLite's write-ahead log needs memory
/// that all its programs share, and locks that hold; there it has neither. FUSE is not refused
/// where it only encrypts, joins or decodes disks of this computer.
bool isNetworkFileSystem(std::string_view type);

/// The type of the network drive on which the file @p path lies or would lie; empty if it is on a
/// disk of this computer, or if that cannot be seen.
std::string networkDriveOf(const std::string& path);

/// @throws StorageError  if the file @p path lies on a network drive, or would.
void requireLocalDisk(const std::string& path);

/// A file that reserves space in a study's folder, so that a session can be finished when the disk
/// is full. (Each MiB held another 4,500 answers when it was measured.)
class ReservedSpace {
 public:
  static constexpr std::uintmax_t kSize = 4 * 1024 * 1024;  ///< [bytes]

  explicit ReservedSpace(const std::filesystem::path& folder) : file_(folder / "ballast") {}

  /// Reserves the space if there is enough; returns whether it is reserved.
  bool take() const noexcept;
  /// Frees the space for the next write; false if none was reserved.
  bool release() const noexcept;

 private:
  std::filesystem::path file_;
};

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
