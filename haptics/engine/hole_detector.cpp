#include "haptics/engine/hole_detector.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>

namespace haptics::engine {

HoleDetector::HoleDetector() noexcept
    : file_(open("/proc/thread-self/schedstat", O_RDONLY | O_CLOEXEC)) {
  if (waited() < 0 && file_ >= 0) {
    close(file_);
    file_ = -1;
  }
  restart();
}

HoleDetector::~HoleDetector() {
  if (file_ >= 0) close(file_);
}

/// How long the thread has waited for a processor in all [ns]: the file's second number. −1 where
/// nobody counts: then the third, how often it had its turn, is 0 although it is running.
std::int64_t HoleDetector::waited() const noexcept {
  char text[96];
  const auto length = file_ < 0 ? -1 : pread(file_, text, sizeof text, 0);
  if (length <= 0) return -1;
  const char* const end = text + length;
  const char* second = std::find(static_cast<const char*>(text), end, ' ');
  if (second == end) return -1;
  std::int64_t waited = -1;
  std::int64_t turns = 0;
  const auto read = std::from_chars(second + 1, end, waited);
  if (read.ptr != end) std::from_chars(read.ptr + 1, end, turns);
  return turns > 0 ? waited : -1;
}

void HoleDetector::restart() noexcept {
  before_ = waited();
}

std::int64_t HoleDetector::ours(std::int64_t late) noexcept {
  const std::int64_t now = waited();
  const bool isCounted = now >= 0 && before_ >= 0;
  const std::int64_t ours = isCounted ? std::clamp<std::int64_t>(now - before_, 0, late) : late;
  before_ = now;
  return ours;
}

}  // namespace haptics::engine
