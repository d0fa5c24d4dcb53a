#include "study/storage/network_drive.h"

#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "study/model/storage_error.h"

namespace study::storage {
namespace {

// Names as in /proc/filesystems, and behind "fuse." as programs call themselves.
constexpr auto kShared = std::to_array<std::string_view>(
    {"9p",     "afs",   "beegfs", "ceph",  "cifs",   "coda",     "drvfs", "glusterfs",
     "gfs2",   "gpfs",  "lustre", "ncpfs", "nfs",    "nfs4",     "ocfs2", "orangefs",
     "prl_fs", "pvfs2", "smb3",   "smbfs", "vboxsf", "virtiofs", "vmhgfs"});
constexpr auto kFuseOfThisComputer = std::to_array<std::string_view>(
    {"fuse.bindfs",
     "fuse.cryfs",
     "fuse.encfs",
     "fuse.exfat",
     "fuse.fuse-overlayfs",
     "fuse.gocryptfs",
     "fuse.mergerfs",
     "fuse.ntfs",
     "fuse.ntfs-3g",
     "fuse.securefs"});

template <typename Names>
bool isAmong(const Names& names, std::string_view type) {
  return std::find(names.begin(), names.end(), type) != names.end();
}

}  // namespace

std::string fileSystemOf(std::string_view mounts, dev_t device) {
  const std::string number = std::to_string(major(device)) + ":" + std::to_string(minor(device));
  std::istringstream lines{std::string(mounts)};
  for (std::string line; std::getline(lines, line);) {
    // 36 35 98:0 /root /place rw,noatime master:1 - ext3 /dev/root rw,errors=continue
    std::istringstream fields(line);
    std::string id;
    std::string parent;
    std::string mounted;
    fields >> id >> parent >> mounted;
    const auto end = line.find(" - ");
    if (mounted != number || end == std::string::npos) continue;
    std::string type;
    std::istringstream(line.substr(end + 3)) >> type;
    return type;
  }
  return {};
}

bool isNetworkFileSystem(std::string_view type) {
  if (type == "fuse" || type.starts_with("fuse.")) return !isAmong(kFuseOfThisComputer, type);
  return isAmong(kShared, type);
}

std::string networkDriveOf(const std::string& path) {
  struct stat info {};
  const auto folder = std::filesystem::absolute(path).parent_path().string();
  if (stat(path.c_str(), &info) != 0 && stat(folder.c_str(), &info) != 0) return {};
  std::ostringstream mounts;
  mounts << std::ifstream("/proc/self/mountinfo").rdbuf();
  const auto type = fileSystemOf(mounts.str(), info.st_dev);
  return isNetworkFileSystem(type) ? type : std::string();
}

void requireOwnDisk(const std::string& path) {
  const auto drive = networkDriveOf(path);
  if (drive.empty()) return;
  throw StorageError(
      path + " is on a network drive (" + drive +
      "), where answers can get lost. Choose a folder on a disk of this computer; 'palpate study "
      "backup' copies a study to one.");
}

}  // namespace study::storage
