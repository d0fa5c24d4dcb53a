#pragma once

#include <cstdint>
#include <string>

namespace study {

/// A moment by two clocks: the one on the wall, which may be set back, and one that only goes on.
struct Moment {
  std::int64_t wall = 0;       ///< since 1970-01-01T00:00:00Z [ms]
  std::int64_t monotonic = 0;  ///< since some start of this computer [ns]
};

/// ISO 8601 in UTC with milliseconds: "2026-11-20T13:35:07.381Z".
std::string asUtc(std::int64_t wallMilliseconds);

/// Tells a study what time it is.
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

/// A clock that goes on when it is told to: simulated sessions, tests.
class SimulatedClock final : public Clock {
 public:
  /// @param wall  [ms] since 1970; by default a morning that nobody will take for a real session.
  explicit SimulatedClock(std::int64_t wall = 946'720'800'000)
      : now_{wall, 0} {}  // 2000-01-01T10:00Z

  Moment now() override { return now_; }
  void advance(double seconds);
  /// Sets the clock on the wall, as people and daylight saving do.
  void setWall(std::int64_t wall) { now_.wall = wall; }

 private:
  Moment now_;
};

}  // namespace study
