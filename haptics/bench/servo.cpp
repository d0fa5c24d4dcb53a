#include "haptics/bench/servo.h"

#include <chrono>
#include <thread>

namespace haptics::bench {

std::vector<ServoMode> servoModes() {
  return {
      {"as any program", false, 0.0},
      {"real-time", true, 0.0},
      {"real-time, spinning", true, 0.05}};
}

ServoRun runServo(const ServoMode& mode, double rate, double seconds) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::microseconds kWork{20};
  engine::RealtimeLoop loop(
      {.rate = rate, .spinning = mode.spinning, .asksForRealtime = mode.asksForRealtime},
      [&](double, double) {
        const auto until = Clock::now() + kWork;
        while (Clock::now() < until) {
        }
      });
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  const bool isRealtime = loop.isRealtime();
  return {.mode = mode.name, .rate = rate, .isRealtime = isRealtime, .report = loop.finish()};
}

}  // namespace haptics::bench
