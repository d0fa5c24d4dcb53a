#include "study/model/new_file.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "study/model/storage_error.h"

namespace study {
namespace {

[[noreturn]] void fail(const std::string& path, int file) {
  const int code = errno;  // read first: close() and unlink() may change it
  if (file >= 0) {
    close(file);
    unlink(path.c_str());
  }
  if (code == EEXIST) {
    throw storage::StorageError(
        path + " is there already. Nothing is ever overwritten: choose another name.");
  }
  throw storage::StorageError(
      "Could not write " + path + " (" + std::generic_category().message(code) +
          "). Check the folder, who may write it, and the room on the disk.",
      isForLackOfRoom(code) ? storage::StorageError::Kind::DiskFull
                            : storage::StorageError::Kind::Other);
}

/// Flushes a file, or the directory entries of a folder.
void flush(const std::filesystem::path& what) {
  const int file = open(what.c_str(), O_RDONLY | O_CLOEXEC);
  const bool isFlushed = file >= 0 && fsync(file) == 0;
  const int code = errno;
  if (file >= 0) close(file);
  // Some file systems cannot flush a folder (EINVAL), and some folders are writable but not
  // readable (EACCES).
  if (isFlushed || code == EINVAL || code == EACCES) return;
  throw storage::StorageError(
      "Could not write " + what.string() + " to the disk (" +
      std::generic_category().message(code) + "). Is the disk healthy and connected?");
}

std::filesystem::path folderOf(const std::filesystem::path& path) {
  return std::filesystem::absolute(path).lexically_normal().parent_path();
}

}  // namespace

void setPrivateUmask() noexcept {
  umask(S_IRWXG | S_IRWXO);
}

void forbidCoreFiles() noexcept {
  // Under a limit of 0 the kernel still starts the program that core_pattern names; under 1 it does
  // not, and 1 byte is too little for a file (core(5)).
  rlimit core{};
  if (getrlimit(RLIMIT_CORE, &core) != 0) return;
  core.rlim_cur = std::min<rlim_t>(1, core.rlim_max);
  setrlimit(RLIMIT_CORE, &core);
}

bool isForLackOfRoom(int error) noexcept {
  return error == ENOSPC || error == EDQUOT;
}

void writeNewFile(const std::string& path, const std::string& content) {
  const int file = open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (file < 0) fail(path, file);
  std::size_t written = 0;
  while (written < content.size()) {
    const auto count = write(file, content.data() + written, content.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(path, file);
    written += static_cast<std::size_t>(count);
  }
  // Before fsync() the data may be in memory only, so a full or failing disk may be reported only
  // here.
  if (fsync(file) != 0) fail(path, file);
  close(file);
  flush(folderOf(path));
}

void requireNewFile(const std::string& path) {
  struct stat ignored {};
  const bool isThere = lstat(path.c_str(), &ignored) == 0;
  if (isThere) errno = EEXIST;
  if (isThere || access(folderOf(path).c_str(), W_OK | X_OK) != 0) fail(path, -1);
}

void flushFolder(const std::filesystem::path& folder) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_symlink()) continue;
    if (entry.is_regular_file() || entry.is_directory()) flush(entry.path());
  }
  flush(folder);
  flush(folderOf(folder));
}

void moveIntoPlace(const std::filesystem::path& folder, const std::filesystem::path& target) {
  flushFolder(folder);
  std::error_code error;
  std::filesystem::rename(folder, target, error);
  if (error) {
    throw storage::StorageError(
        "Could not finish " + target.string() + " (" + error.message() + ").");
  }
  flush(folderOf(target));
}

std::filesystem::path makeFolderBeside(const std::filesystem::path& target) {
  std::error_code error;
  const auto parent = std::filesystem::absolute(target).parent_path();
  std::filesystem::create_directories(parent, error);
  std::string name = (parent / (target.filename().string() + kUnfinished + "XXXXXX")).string();
  if (error || mkdtemp(name.data()) == nullptr) {
    const int code = error ? error.value() : errno;
    throw storage::StorageError(
        "Could not make the folder " + target.string() + " (" +
        std::generic_category().message(code) +
        (code == ENAMETOOLONG ? "). Choose a shorter name." : "). Choose another place."));
  }
  return name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace study
