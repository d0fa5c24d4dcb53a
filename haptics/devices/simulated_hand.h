#pragma once

#include <cstdint>

#include "haptics/devices/hand.h"

namespace haptics::devices {

/// A hand that closes and opens (advances and withdraws), again and again: an impedance around a
/// point of equilibrium that moves as people move,
///
///     F = k (x₀(t) − x) + b (ẋ₀(t) − ẋ),
///
/// with x₀ on a minimum-jerk path x₀ = a + (b − a)(10 τ³ − 15 τ⁴ + 6 τ⁵) (Flash & Hogan 1985). What
/// it meets therefore changes what it does: a stiffer tissue is entered less far.
class SimulatedHand final : public Hand {
 public:
  /// One person's hand. Travel in the device's unit.
  struct Person {
    double open = 0.0;       ///< where it starts and returns to
    double closed = 13.5;    ///< where it means to go; resistance keeps it short of that
    double pauseTime = 0.4;  ///< before each closing [s]
    double closeTime = 0.6;  ///< [s], > 0
    double holdTime = 0.15;  ///< [s]
    double openTime = 0.5;   ///< [s], > 0
    double stiffness = 3.0;  ///< k [N / travel unit], > 0
    double damping = 0.12;   ///< b [N·s / travel unit], >= 0
    double variation =
        0.0;  ///< how much one closing differs from the next in reach and time, [0, 0.5]
    std::uint64_t seed = 0;  ///< of these differences
  };

  /// @throws std::invalid_argument  if a time or the stiffness makes no sense.
  explicit SimulatedHand(const Person& person);

  double push(double travel, double velocity, double dt) noexcept override;

 private:
  struct Target {
    double position = 0.0;
    double velocity = 0.0;
  };
  Target target() const noexcept;
  void beginCycle() noexcept;
  double chance() noexcept;

  Person person_;
  double time_ = 0.0;  ///< since the present cycle began [s]
  std::uint64_t state_;
  double closed_ = 0.0;     ///< in this cycle
  double closeTime_ = 0.0;  ///< in this cycle [s]
};

}  // namespace haptics::devices
