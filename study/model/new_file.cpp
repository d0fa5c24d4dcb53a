#include "study/model/new_file.h"

#include <fcntl.h>
#include <unistd.h>

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
      code == ENOSPC ? storage::StorageError::Kind::DiskFull : storage::StorageError::Kind::Other);
}

}  // namespace

void writeNewFile(const std::string& path, const std::string& content) {
  const int file = open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0644);
  if (file < 0) fail(path, file);
  std::size_t written = 0;
  while (written < content.size()) {
    const auto count = write(file, content.data() + written, content.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(path, file);
    written += static_cast<std::size_t>(count);
  }
  // Until here the data may be in memory only; a full or failing disk may show not before now.
  if (fsync(file) != 0) fail(path, file);
  close(file);
}

std::filesystem::path newFolderBeside(const std::filesystem::path& target) {
  std::error_code error;
  const auto parent = std::filesystem::absolute(target).parent_path();
  std::filesystem::create_directories(parent, error);
  std::string name = (parent / (target.filename().string() + ".unfinished-XXXXXX")).string();
  if (error || mkdtemp(name.data()) == nullptr) {
    const auto why = error ? error.message() : std::generic_category().message(errno);
    throw storage::StorageError(
        "Could not make the folder " + target.string() + " (" + why + "). Choose another place.");
  }
  std::filesystem::permissions(name, std::filesystem::perms(0755), error);
  return name;
}

}  // namespace study
