#pragma once

#include <string>
#include <vector>

#include "haptics/engine/realtime_loop.h"

namespace haptics::bench {

/// How a loop is scheduled.
struct ServoMode {
  std::string name;
  bool asksForRealtime = false;
  double spinning = 0.0;  ///< share of a period
};

/// As any program; with real-time priority, locked memory and no timer slack; and spinning as well.
std::vector<ServoMode> servoModes();

struct ServoRun {
  std::string mode;
  double rate = 0.0;        ///< [Hz]
  bool isRealtime = false;  ///< what was asked for was granted
  engine::RealtimeLoop::Report report;
};

/// Runs the loop for @p seconds, each tick with 20 µs of work.
ServoRun runServo(const ServoMode& mode, double rate, double seconds);

}  // namespace haptics::bench
