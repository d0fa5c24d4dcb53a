#include "study/storage/local_disk.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include "study/model/new_file.h"
#include "study/model/storage_error.h"
#include "study/storage/database.h"
#include "study/storage/statement.h"

namespace study::storage {
namespace {

// Names of file systems as in /proc/filesystems, and of programs after "fuse.".
constexpr auto kNetworkFileSystemTypes = std::to_array<std::string_view>(
    {"9p",     "afs",   "beegfs", "ceph",  "cifs",   "coda",     "drvfs", "glusterfs",
     "gfs2",   "gpfs",  "lustre", "ncpfs", "nfs",    "nfs4",     "ocfs2", "orangefs",
     "prl_fs", "pvfs2", "smb3",   "smbfs", "vboxsf", "virtiofs", "vmhgfs"});
constexpr auto kLocalFuseTypes = std::to_array<std::string_view>(
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
  return std::ranges::find(names, type) != names.end();
}

}  // namespace

std::string fileSystemOf(std::string_view mounts, dev_t device) {
  const std::string number = std::to_string(major(device)) + ":" + std::to_string(minor(device));
  std::istringstream lines{std::string(mounts)};
  for (std::string line; std::getline(lines, line);) {
    // a line: 36 35 98:0 /root /place rw,noatime master:1 - ext3 /dev/root rw,errors=continue
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
  if (type == "fuse" || type.starts_with("fuse.")) return !isAmong(kLocalFuseTypes, type);
  return isAmong(kNetworkFileSystemTypes, type);
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

void requireLocalDisk(const std::string& path) {
  const auto drive = networkDriveOf(path);
  if (drive.empty()) return;
  throw StorageError(
      path +
      (drive == "fuse" ? " is on a drive of unknown kind (fuse), perhaps of another computer"
                       : " is on a network drive (" + drive + ")") +
      ", where answers can get lost. Choose a folder on a disk of this computer; 'palpate study "
      "backup' copies a study to one.");
}

bool ReservedSpace::take() const noexcept {
  std::error_code ignored;
  if (std::filesystem::exists(file_, ignored)) return true;
  const int file = open(file_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0600);
  if (file < 0) return false;
  // Allocates the blocks. Setting the size alone would make a sparse file, which reserves nothing.
  const bool hasRoom = posix_fallocate(file, 0, static_cast<off_t>(kSize)) == 0;
  close(file);
  if (!hasRoom) release();
  return hasRoom;
}

bool ReservedSpace::release() const noexcept {
  std::error_code ignored;
  return std::filesystem::remove(file_, ignored);
}

bool ReservedSpace::isDiskAlmostFull() const noexcept {
  std::error_code error;
  const auto space = std::filesystem::space(file_.parent_path(), error);
  return !take() || (!error && space.available < kSize);
}

namespace {

constexpr std::array<std::string_view, 1> kSteps{"CREATE TABLE row (words TEXT NOT NULL) STRICT"};
constexpr Schema kSchema{0x70616c63, "a file for a self-test", kSteps};

}  // namespace

CommitTimes measureCommits(const std::filesystem::path& folder, int commits) {
  using Clock = std::chrono::steady_clock;
  const TemporaryFolder passing(folder);
  auto database = Database::create((passing / "self-test.db").string(), kSchema);
  std::vector<double> times;
  for (int i = 0; i < commits; ++i) {
    const auto begin = Clock::now();
    Transaction transaction(database);
    Statement insert(database, "INSERT INTO row (words) VALUES (?)");
    insert.bindAll("an answer of ordinary length, with its audit line beside it");
    insert.run();
    transaction.commit();
    times.push_back(std::chrono::duration<double>(Clock::now() - begin).count());
  }
  if (times.empty()) return {};
  std::ranges::sort(times);
  return {.commits = commits, .median = times[times.size() / 2], .longest = times.back()};
}

}  // namespace study::storage
