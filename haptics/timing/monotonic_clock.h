#pragma once

#include <sched.h>
#include <sys/types.h>

#include <cstdint>
#include <ctime>

namespace haptics::timing {

inline constexpr std::int64_t kSecond = 1'000'000'000;   ///< [ns]
inline constexpr std::int64_t kMillisecond = 1'000'000;  ///< [ns]
inline constexpr std::int64_t kMicrosecond = 1'000;      ///< [ns]

/// The time of CLOCK_MONOTONIC [ns], which all programs on this computer share.
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

/// Priorities under SCHED_FIFO. Emulated hardware has the highest, because a real board or robot
/// does not wait for a processor of this computer.
inline constexpr int kEmulatorPriority = 85;
inline constexpr int kLoopPriority = 80;      ///< for threads that tick a device or answer it
inline constexpr int kObserverPriority = 70;  ///< for threads that only observe

/// Gives a thread (0: the calling one) real-time priority. Returns false, and changes nothing, if
/// the system refuses.
inline bool raisePriority(int priority, pid_t thread = 0) noexcept {
  const sched_param parameters{.sched_priority = priority};
  return sched_setscheduler(thread, SCHED_FIFO, &parameters) == 0;
}

}  // namespace haptics::timing
