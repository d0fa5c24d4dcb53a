#pragma once

#include <cstdint>

namespace haptics::devices {

/// What sets the pace of a loop instead of a timer: a device that sends, and wants an answer.
class Beat {
 public:
  virtual ~Beat() = default;
  Beat() = default;
  Beat(const Beat&) = delete;
  Beat& operator=(const Beat&) = delete;

  /// Waits for the next beat, no longer than until @p deadline [ns on CLOCK_MONOTONIC]. False where
  /// none came.
  virtual bool wait(std::int64_t deadline) noexcept = 0;
};

}  // namespace haptics::devices
