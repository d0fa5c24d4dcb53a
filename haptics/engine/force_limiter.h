#pragma once

#include <cstdint>

namespace haptics::engine {

/// The last word before the motors: saturates, limits the rate of change, refuses what is no
/// number.
///
/// It cannot be switched off. When in doubt, it answers with no force.
class ForceLimiter {
 public:
  struct Limits {
    double maxForce = 3.0;   ///< [N], > 0
    double maxRate = 300.0;  ///< how fast a force may change [N/s], > 0
  };

  /// What the limiter had to do to a force, as bits.
  enum Intervention : std::uint8_t {
    None = 0,
    Saturated = 1,
    Slewed = 2,
    NotFinite = 4,
  };

  struct Limited {
    double force = 0.0;  ///< [N]
    std::uint8_t interventions = None;
  };

  /// @throws std::invalid_argument  if a limit is not a positive finite number.
  explicit ForceLimiter(const Limits& limits);

  /// The nearest allowed force to @p desired [N], @p dt [s] after the last one.
  Limited limit(double desired, double dt) noexcept;

  /// Lets go at once: the next force starts from none.
  void release() noexcept { last_ = 0.0; }

  const Limits& limits() const noexcept { return limits_; }

 private:
  Limits limits_;
  double last_ = 0.0;
};

}  // namespace haptics::engine
