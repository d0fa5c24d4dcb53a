#pragma once

#include <cstdint>

#include "haptics/engine/safety_limits.h"

namespace haptics::engine {

/// How much of a force is let through, from 0 to 1: none while something is wrong, and all of it
/// only after a soft start.
///
/// - A scene that is new, and a stop that is over, start softly: nothing until the scene asks for a
///   small force, then more and more over the ramp. So does a hand that takes the switch again, and
///   one that has become slow again.
/// - A sample that is missing is bridged by the last force for one tick; then the force fades.
/// - A beat that was lost was bridged by the device itself; more than one fades the force by what
///   it should have faded since, and it comes back over the ramp.
class ForceGate {
 public:
  /// Why the gate is not all open, as bits.
  enum Reason : std::uint8_t {
    None = 0,
    TooFast = 1,    ///< the tool exceeds the limit of velocity
    Released = 2,   ///< nobody holds the dead-man switch
    NoSample = 4,   ///< the device gave no new measurement
    LostBeats = 8,  ///< the clock lost more than one beat
    SoftStart = 16  ///< waits for a small force, or lets it come on
  };

  struct Input {
    bool isMeasured = true;  ///< there is a new sample
    bool isHeld = true;      ///< somebody holds the dead-man switch
    double velocity = 0.0;   ///< [device's travel unit/s]
    double desired = 0.0;    ///< what the scene asks for [N]
    int lostBeats = 0;       ///< before this tick
  };

  struct Output {
    double gain = 0.0;  ///< [0, 1]
    std::uint8_t reasons = None;
    bool isPatienceOver = false;  ///< the device has failed to deliver for too long
  };

  explicit ForceGate(const SafetyLimits& limits) noexcept : limits_(limits) {}

  /// One step of @p dt [s].
  Output step(const Input& input, double dt) noexcept;

  /// Shuts at once; what comes next starts softly.
  void shut() noexcept;

  /// What comes next starts softly; the force that is there fades.
  void startSoftly() noexcept { isWaiting_ = true; }

 private:
  std::uint8_t closingReasons(const Input& input, double dt) noexcept;

  SafetyLimits limits_;
  double gain_ = 0.0;
  double silence_ = 0.0;   ///< since the last measurement [s]
  bool isWaiting_ = true;  ///< for a small force
};

}  // namespace haptics::engine
