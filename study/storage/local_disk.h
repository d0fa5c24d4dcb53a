#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace study::storage {

/// The type of the file system with device number @p device: "ext4", "fuse.sshfs". Empty if
/// @p mounts, the text of /proc/self/mountinfo (proc_pid_mountinfo(5)), does not list it.
std::string fileSystemOf(std::string_view mounts, dev_t device);

/// Whether another computer can change the files of such a file system (NFS, SMB, 9p, Ceph and the
/// like), or a program serves them (FUSE). SQLite's write-ahead log needs memory that all programs
/// share and reliable locks, which such file systems lack. FUSE file systems that only encrypt,
/// join or decode disks of this computer are accepted.
bool isNetworkFileSystem(std::string_view type);

/// The type of the network drive of the file @p path, which need not exist; empty if the file is on
/// a disk of this computer, or if the type cannot be determined.
std::string networkDriveOf(const std::string& path);

/// @throws StorageError  if the file @p path is, or would be, on a network drive.
void requireLocalDisk(const std::string& path);

/// A file that reserves space in a study's folder, so that a session can be finished when the disk
/// is full. (1 MiB held 4,500 answers when measured.)
class ReservedSpace {
 public:
  static constexpr std::uintmax_t kSize = 4 * 1024 * 1024;  ///< [bytes]

  explicit ReservedSpace(const std::filesystem::path& folder) : file_(folder / "ballast") {}

  /// Reserves the space if the disk has it; returns whether it is reserved.
  bool take() const noexcept;
  /// Frees the reserved space for the next write; false if none was reserved.
  bool release() const noexcept;
  /// Reserves the space again if it was freed. Whether the disk has no room for it, or has less
  /// than that free besides.
  bool isDiskAlmostFull() const noexcept;

 private:
  std::filesystem::path file_;
};

/// Times of committing answers to the disk.
struct CommitTimes {
  int commits = 0;
  double median = 0.0;   ///< [s]
  double longest = 0.0;  ///< [s]
};

/// Commits @p commits small rows with the settings of a study (write-ahead log, synchronous=FULL)
/// to a new file in @p folder, which is removed afterwards.
/// @throws StorageError  if the folder cannot be written.
CommitTimes measureCommits(const std::filesystem::path& folder, int commits);

}  // namespace study::storage
