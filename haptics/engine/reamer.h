#pragma once

#include <limits>

namespace haptics::engine {

/// The cutting tool of a scene: how fast it turns, and how much its teeth can take.
///
/// In every turn each tooth takes a chip of at most feedPerTooth, so that the tool advances through
/// bone no faster than
///
///     feed = speed · teeth · feedPerTooth,
///
/// the kinematics of milling. docs/decisions/0030-reaming-takes-time.md argues the defaults.
struct Reamer {
  static constexpr double kMostSpeed = 100.0;  ///< either way [1/s]

  /// Turns in a second, in [−100, 100]; the sign is the spin: above 0 the teeth cut, below 0 their
  /// backs rub.
  double speed = 5.0;
  int teeth = 4;                 ///< that pass each place of the surface in one turn, >= 1
  double feedPerTooth = 0.1e-3;  ///< [m], > 0; may be infinite
  bool hasTorque = true;         ///< release 0.1 rendered forces alone

  /// How fast it can go through bone [m/s]; 0 where it stands still or turns backwards.
  constexpr double mostFeed() const noexcept {
    return speed > 0.0 ? speed * teeth * feedPerTooth : 0.0;
  }

  /// The direction of the torque on the hand about the way of advancing: bone holds the teeth, so
  /// it is against the spin. 1, −1, or 0 where the reamer stands still.
  constexpr int torqueSign() const noexcept {
    if (!hasTorque || speed == 0.0) return 0;
    return speed > 0.0 ? -1 : 1;
  }

  /// A force grows with the thickness of the chip, so that a cutting damping falls with the teeth
  /// that pass in a second.
  /// @param stated  that of the default reamer, whose teeth pass 20 times a second [N·s/m].
  constexpr double dampingOf(double stated) const noexcept {
    constexpr double kPassesOfTheDefault = 20.0;  // [1/s]
    return speed > 0.0 ? stated * (kPassesOfTheDefault / (speed * teeth)) : stated;
  }

  /// That of release 0.1, which took whatever it was pushed through.
  static constexpr Reamer withoutLimit() noexcept {
    return {.feedPerTooth = std::numeric_limits<double>::infinity(), .hasTorque = false};
  }

  constexpr bool isSound() const noexcept {
    return speed >= -kMostSpeed && speed <= kMostSpeed && teeth >= 1 && feedPerTooth > 0.0;
  }
};

}  // namespace haptics::engine
