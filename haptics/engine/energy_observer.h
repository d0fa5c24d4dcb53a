#pragma once

#include <limits>

namespace haptics::engine {

/// Observes whether a scene returns more energy than the hand put in, and damps it on request:
/// time-domain passivity (Hannaford & Ryu 2002; for a force that is held over a step Ryu, Preusche,
/// Hirzinger & Hannaford 2005).
///
/// The force f that is held while the tool moves on by Δx takes up f Δx; the mechanism's damping b
/// takes up b v² Δt besides:
///
///     E ← E + f Δx + b v² Δt.
///
/// E < 0 says that the rendered scene and the mechanism together are active. Each contact is
/// counted separately: without a force E starts at 0 again, so that the dissipation of one cut does
/// not hide generation in the next. A turn is observed in the same way, with
/// torque [N·m] and angle [rad] for force and travel.
class EnergyObserver {
 public:
  struct Settings {
    double deviceDamping = 0.0;   ///< b [N·s per travel unit], >= 0
    double tolerance = 0.0;       ///< that E may lie below 0 [N·travel unit], >= 0
    double mostDamping = 0.0;     ///< that the controller may add [N·s per travel unit]; 0: none
    double leastVelocity = 1e-9;  ///< below, nothing is damped [travel unit/s], > 0
    double noForce = 1e-3;        ///< below, there is no contact [N]
  };

  explicit EnergyObserver(const Settings& settings) noexcept : settings_(settings) {}

  /// Counts what has happened since the last step: @p held [N] was on the tool while it moved by
  /// @p moved [travel unit] at @p velocity [travel unit/s].
  void observe(double held, double moved, double velocity, double dt) noexcept;

  /// The force that dissipates what was given too much: @p desired, and damping of at most
  /// mostDamping against the motion.
  double damped(double desired, double velocity, double dt) const noexcept;

  bool isActive() const noexcept { return energy_ < -settings_.tolerance; }
  double energy() const noexcept { return energy_; }  ///< E of this contact [N·travel unit]
  double least() const noexcept { return least_; }    ///< the least E ever seen
  void reset() noexcept { energy_ = 0.0; }

 private:
  Settings settings_;
  double energy_ = 0.0;
  double least_ = 0.0;
};

}  // namespace haptics::engine
