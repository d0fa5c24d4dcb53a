#pragma once

#include <cstdint>

#include "haptics/engine/safety_limits.h"

namespace haptics::engine {

/// The last word before the motors: saturates, limits the rate of change, refuses what is no
/// number.
///
/// It cannot be switched off. When in doubt, it answers with no force.
class ForceLimiter {
 public:
  /// What had to be done to a force, as bits.
  enum Intervention : std::uint8_t {
    None = 0,
    Saturated = 1,
    Slewed = 2,
    NotFinite = 4,
    Damped = 8,   ///< not the limiter: damping was added against too much energy
    Active = 16,  ///< not the limiter: the scene has given more energy than it was given
  };

  struct Limited {
    double force = 0.0;  ///< [N]
    std::uint8_t interventions = None;
  };

  /// @throws std::invalid_argument  if maxForce or maxRate is not a positive finite number.
  explicit ForceLimiter(const SafetyLimits& limits);

  /// The nearest allowed force to @p desired [N], @p dt [s] after the last one.
  Limited limit(double desired, double dt) noexcept;

  /// Lets go at once: the next force starts from none.
  void release() noexcept { last_ = 0.0; }

 private:
  SafetyLimits limits_;
  double last_ = 0.0;
};

}  // namespace haptics::engine
