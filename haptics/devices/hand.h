#pragma once

#include <atomic>
#include <cstdint>
#include <limits>

#include "base/random.h"

namespace haptics::devices {

/// A model of the hand that moves a simulated tool.
class Hand {
 public:
  virtual ~Hand() = default;
  Hand() = default;
  Hand(const Hand&) = delete;
  Hand& operator=(const Hand&) = delete;

  /// Returns the force [N] of the hand on a tool at @p travel with @p velocity, @p dt [s] after the
  /// last call. Positive closes or advances.
  virtual double push(double travel, double velocity, double dt) noexcept = 0;
};

/// A hand that repeatedly closes and opens (advances and withdraws): an impedance around an
/// equilibrium point that moves as a human hand does,
///
///     F = k (x₀(t) − x) + b (ẋ₀(t) − ẋ),
///
/// with x₀ on a minimum-jerk path x₀ = a + (b − a)(10 τ³ − 15 τ⁴ + 6 τ⁵) (Flash & Hogan 1985). The
/// resistance therefore changes the movement: in a stiffer tissue the hand moves less far.
class SimulatedHand final : public Hand {
 public:
  /// The parameters of one person's hand; travel in the device's unit.
  struct Person {
    double open = 0.0;       ///< where it starts and returns to
    double closed = 13.5;    ///< travel that it aims at; resistance stops it earlier
    double pauseTime = 0.4;  ///< before each closing [s]
    double closeTime = 0.6;  ///< [s], > 0
    double holdTime = 0.15;  ///< [s]
    double openTime = 0.5;   ///< [s], > 0
    double stiffness = 3.0;  ///< k [N / travel unit], > 0
    double damping = 0.12;   ///< b [N·s / travel unit], >= 0
    /// Relative random variation of reach and closing time from cycle to cycle, [0, 0.5]
    double variation = 0.0;
    std::uint64_t seed = 0;  ///< of the random variation
  };

  /// @throws std::invalid_argument  if a time or the stiffness is out of range.
  explicit SimulatedHand(const Person& person);

  double push(double travel, double velocity, double dt) noexcept override;

 private:
  struct Target {
    double position = 0.0;
    double velocity = 0.0;
  };
  Target target() const noexcept;
  void beginCycle() noexcept;
  /// A random number in [−1, 1).
  double deviation() noexcept { return 2.0 * random_.uniform() - 1.0; }

  Person person_;
  double time_ = 0.0;  ///< since the present cycle began [s]
  base::SplitMix64 random_;
  double cycleReach_ = 0.0;  ///< travel that the hand aims at in this cycle
  double closeTime_ = 0.0;   ///< duration of closing in this cycle [s]
};

/// A hand that follows a pointer, moved by the mouse or the keys, if there is no device. Another
/// thread sets its target.
class PointerHand final : public Hand {
 public:
  struct Grip {
    double stiffness = 3.0;  ///< [N / travel unit]
    double damping = 0.12;   ///< [N·s / travel unit]
    /// Largest speed at which the grip follows the pointer [travel units / s].
    double speed = 40.0;
    double strength = std::numeric_limits<double>::infinity();  ///< largest force of the hand in
                                                                ///< either direction [N]
  };

  explicit PointerHand(const Grip& grip) noexcept : grip_(grip) {}

  /// Sets the travel that the hand moves to [travel unit]. May be called from any thread.
  void moveTo(double travel) noexcept { targetTravel_.store(travel, std::memory_order_relaxed); }

  double push(double travel, double velocity, double dt) noexcept override;

 private:
  Grip grip_;
  std::atomic<double> targetTravel_{0.0};
  double position_ = 0.0;
};

}  // namespace haptics::devices
