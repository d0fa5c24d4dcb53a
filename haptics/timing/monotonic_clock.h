#pragma once

#include <cstdint>
#include <ctime>

namespace haptics::timing {

inline constexpr std::int64_t kSecond = 1'000'000'000;   ///< [ns]
inline constexpr std::int64_t kMillisecond = 1'000'000;  ///< [ns]
inline constexpr std::int64_t kMicrosecond = 1'000;      ///< [ns]

/// CLOCK_MONOTONIC [ns]: the same for all programs on this computer.
inline std::int64_t now() noexcept {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec * kSecond + time.tv_nsec;
}

/// Sleeps until @p due [ns on CLOCK_MONOTONIC].
inline void sleepUntil(std::int64_t due) noexcept {
  const timespec time{.tv_sec = due / kSecond, .tv_nsec = due % kSecond};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr) != 0) {
  }
}

}  // namespace haptics::timing
