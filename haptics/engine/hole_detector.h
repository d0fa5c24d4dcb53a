#pragma once

#include <cstdint>

namespace haptics::engine {

/// Tells whose fault it is that a thread woke up late.
///
/// A thread that waits for a processor although its time has come counts that in
/// /proc/thread-self/schedstat: other work of this machine, ours to answer for. The rest of the
/// lateness is a hole: the timer itself came late, because whoever runs this (virtual) machine had
/// stopped it, or its firmware had. Where the kernel does not count, everything is ours.
class HoleDetector {
 public:
  /// Belongs to the thread that makes it.
  HoleDetector() noexcept;
  ~HoleDetector();
  HoleDetector(const HoleDetector&) = delete;
  HoleDetector& operator=(const HoleDetector&) = delete;

  bool isAvailable() const noexcept { return file_ >= 0; }

  /// Begins to count anew: call it now and then while nothing is late, so that the small change of
  /// many wake-ups does not add up.
  void restart() noexcept;

  /// Of @p late [ns], what this machine answers for [ns]; the rest is a hole. Restarts.
  std::int64_t ours(std::int64_t late) noexcept;

 private:
  std::int64_t waited() const noexcept;

  int file_ = -1;
  std::int64_t before_ = 0;
};

}  // namespace haptics::engine
