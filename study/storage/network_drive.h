#pragma once

#include <sys/types.h>

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
void requireOwnDisk(const std::string& path);

}  // namespace study::storage
