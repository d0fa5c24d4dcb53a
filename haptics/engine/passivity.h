#pragma once

#include <optional>

namespace haptics::engine {

/// A force that keeps oscillating while the tool rests.
struct LimitCycle {
  double amplitude = 0.0;  ///< peak to peak [N]
  double frequency = 0.0;  ///< [Hz]
  double travel = 0.0;     ///< where the amplitude is largest [travel units]
};

/// The energy that a sampled force adds to the hand, and the damping that prevents it: eq. (25) of
/// the punch paper, b > K T / 2 (Colgate & Schenkel 1997).
///
/// A force that is held constant for a period while the tool moves is too small on the way in and
/// too large on the way out, and so generates energy. Damping of at least K T / 2, of mechanism and
/// hand together, dissipates it.
struct Passivity {
  double stiffness = 0.0;    ///< K: the steepest slope that is rendered [N per travel unit]
  double period = 0.001;     ///< of the loop [s]
  double lateness = 0.0;     ///< 99.9 % quantile of the loop's wake-up lateness [s]
  double filterDelay = 0.0;  ///< delay between sensor and force [s]
  /// The limit cycle with a resting hand; std::nullopt: none. With a limit cycle no damping makes
  /// the rendering passive.
  std::optional<LimitCycle> limitCycle = {};

  /// The period T [s], extended by lateness and delay: a late tick holds the old force for longer.
  /// A delay τ counts twice, because a sampled force is T/2 old on average, but τ old always: b > K
  /// (T/2 + τ) (Gil, Sánchez, Hulin, Preusche & Hirzinger 2009). `palpate bench stability` shows
  /// walls that vibrate if the delay is counted once.
  constexpr double effectivePeriod() const noexcept {
    return period + lateness + 2.0 * filterDelay;
  }

  /// b: the damping that is needed [N·s per travel unit].
  constexpr double requiredDamping() const noexcept { return stiffness * effectivePeriod() / 2.0; }

  /// Whether a @p damping of mechanism and hand [N·s per travel unit] dissipates all energy that
  /// the loop generates.
  constexpr bool isPassiveWith(double damping) const noexcept {
    return !limitCycle && requiredDamping() <= damping;
  }

  /// Mean error of the held force at a speed [travel units/s]: K v T / 2 [N].
  constexpr double forceErrorAt(double speed) const noexcept {
    return stiffness * speed * effectivePeriod() / 2.0;
  }

  /// The largest passive stiffness [N per travel unit] for a damping [N·s per travel unit].
  constexpr double allowedStiffness(double damping) const noexcept {
    return 2.0 * damping / effectivePeriod();
  }
};

/// Observes whether a scene returns more energy than the hand put in, and damps it on request:
/// time-domain passivity (Hannaford & Ryu 2002; for a force that is held over a step Ryu, Preusche,
/// Hirzinger & Hannaford 2005).
///
/// The force f that is held while the tool moves by Δx absorbs the energy f Δx; the mechanism's
/// damping b absorbs b v² Δt:
///
///     E ← E + f Δx + b v² Δt.
///
/// E < 0 means that the rendered scene and the mechanism together are active. Each contact is
/// counted separately: without a force E is reset to 0, so that energy dissipated in one cut does
/// not hide energy generated in the next. A second observer, with torque [N·m] and angle [rad] for
/// force and travel, observes the rotation.
class EnergyObserver {
 public:
  struct Settings {
    double deviceDamping = 0.0;  ///< b [N·s per travel unit], >= 0
    double tolerance = 0.0;      ///< E below −tolerance counts as active [N·travel unit], >= 0
    /// Largest damping that damped() adds [N·s per travel unit]; 0: none.
    double mostDamping = 0.0;
    double leastVelocity = 1e-9;  ///< no damping is added below this speed [travel unit/s], > 0
    double noForce = 1e-3;        ///< below this force there is no contact [N]
  };

  explicit EnergyObserver(const Settings& settings) noexcept : settings_(settings) {}

  /// Adds the energy of the last step of @p dt [s]: the force @p held [N] was on the tool while it
  /// moved by @p moved [travel unit] at @p velocity [travel unit/s].
  void observe(double held, double moved, double velocity, double dt) noexcept;

  /// Returns @p desired [N], plus a damping force that dissipates the generated energy, with at
  /// most mostDamping.
  double damped(double desired, double velocity, double dt) const noexcept;

  bool isActive() const noexcept { return energy_ < -settings_.tolerance; }
  double energy() const noexcept { return energy_; }      ///< E of this contact [N·travel unit]
  double least() const noexcept { return leastEnergy_; }  ///< smallest E since construction
  void reset() noexcept { energy_ = 0.0; }

 private:
  Settings settings_;
  double energy_ = 0.0;
  double leastEnergy_ = 0.0;
};

}  // namespace haptics::engine
