#include "study/storage/reserved_space.h"

#include <fcntl.h>
#include <unistd.h>

#include <system_error>

namespace study::storage {

bool ReservedSpace::take() const noexcept {
  std::error_code ignored;
  if (std::filesystem::exists(file_, ignored)) return true;
  const int file = open(file_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0600);
  if (file < 0) return false;
  // Allocates the blocks. A file of this size alone would be sparse and reserve nothing.
  const bool hasRoom = posix_fallocate(file, 0, static_cast<off_t>(kSize)) == 0;
  close(file);
  if (!hasRoom) release();
  return hasRoom;
}

bool ReservedSpace::release() const noexcept {
  std::error_code ignored;
  return std::filesystem::remove(file_, ignored);
}

}  // namespace study::storage
