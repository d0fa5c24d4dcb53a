#pragma once

#include <cstdint>
#include <string>

namespace study {

/// A moment on two clocks: the wall clock, which may be set back, and a monotonic one.
struct Moment {
  std::int64_t wall = 0;       ///< since 1970-01-01T00:00:00Z [ms]
  std::int64_t monotonic = 0;  ///< since this computer started [ns]
};

/// ISO 8601 in UTC with milliseconds: "2026-11-20T13:35:07.381Z".
std::string asUtc(std::int64_t wallMilliseconds);

/// Gives a study the time.
class Clock {
 public:
  virtual ~Clock() = default;
  Clock() = default;
  Clock(const Clock&) = delete;
  Clock& operator=(const Clock&) = delete;

  virtual Moment now() = 0;
};

/// The clocks of this computer.
class SystemClock final : public Clock {
 public:
  Moment now() override;
};

/// A clock that the caller advances: for simulated sessions and tests.
class SimulatedClock final : public Clock {
 public:
  /// @param wall  [ms] since 1970-01-01; by default the year 2000, so that simulated sessions
  ///     cannot be taken for real ones.
  explicit SimulatedClock(std::int64_t wall = 946'720'800'000)
      : now_{wall, 0} {}  // 2000-01-01T10:00Z

  Moment now() override { return now_; }
  void advance(double seconds);
  /// Sets the wall clock alone, as a person or daylight saving time does.
  void setWall(std::int64_t wall) { now_.wall = wall; }

 private:
  Moment now_;
};

}  // namespace study
