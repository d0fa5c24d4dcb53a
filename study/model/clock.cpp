#include "study/model/clock.h"

#include <chrono>
#include <cmath>

#include <fmt/format.h>

namespace study {

std::string asUtc(std::int64_t wallMilliseconds) {
  using namespace std::chrono;
  const sys_time<milliseconds> time{milliseconds(wallMilliseconds)};
  const auto day = floor<days>(time);
  const year_month_day date(day);
  const hh_mm_ss clock(time - day);
  return fmt::format(
      "{:04d}-{:02d}-{:02d}T{:02d}:{:02d}:{:02d}.{:03d}Z",
      static_cast<int>(date.year()),
      static_cast<unsigned>(date.month()),
      static_cast<unsigned>(date.day()),
      clock.hours().count(),
      clock.minutes().count(),
      clock.seconds().count(),
      clock.subseconds().count());
}

Moment SystemClock::now() {
  using namespace std::chrono;
  return {
      duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count(),
      duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count()};
}

void SimulatedClock::advance(double seconds) {
  const auto step = static_cast<std::int64_t>(std::llround(seconds * 1000.0));
  now_.wall += step;
  now_.monotonic += step * 1'000'000;
}

}  // namespace study
