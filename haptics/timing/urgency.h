#pragma once

#include <sched.h>
#include <sys/types.h>

namespace haptics::timing {

/// Priorities under SCHED_FIFO. What stands in for hardware goes first: a real board and a real
/// robot do not wait for a processor of this computer.
inline constexpr int kStandInUrgency = 85;
inline constexpr int kLoopUrgency = 80;     ///< who ticks a device, or answers it
inline constexpr int kWatcherUrgency = 70;  ///< who looks on

/// Lets a thread (0: this one) go before ordinary programs; false where the system does not grant
/// it, and the thread goes on as it was.
inline bool makeUrgent(int urgency, pid_t thread = 0) noexcept {
  const sched_param parameters{.sched_priority = urgency};
  return sched_setscheduler(thread, SCHED_FIFO, &parameters) == 0;
}

}  // namespace haptics::timing
