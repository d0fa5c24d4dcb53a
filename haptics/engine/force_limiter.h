#pragma once

#include <cstdint>
#include <limits>

namespace haptics::engine {

/// Limits of force, torque and velocity. Saturation, slew limit and the check for finite values
/// cannot be switched off.
struct SafetyLimits {
  double maxForce = 3.0;   ///< [N], > 0
  double maxRate = 300.0;  ///< how fast a force may change [N/s], > 0

  double maxTorque = 5.0;       ///< about the tool's axis [N·m], > 0
  double maxTorqueRate = 50.0;  ///< how fast a torque may change [N·m/s], > 0

  /// Faster motion is impossible for a hand: the force then fades [device's travel unit/s], > 0.
  double maxVelocity = std::numeric_limits<double>::infinity();

  /// Duration of the ramp of the force when the gate opens or closes [s], > 0.
  double rampTime = 0.1;

  /// A soft start begins only when the scene's force is at most this fraction of maxForce, in (0,
  /// 1].
  double softStartShare = 0.1;

  /// Time without a new sample after which the engine stops [s], > 0.
  double longestSilence = 0.1;

  /// Adds damping when the scene generates energy; if false, the energy is only reported.
  bool isPassivityControlled = false;
};

/// The last stage before the motors: saturates, limits the rate of change, replaces non-finite
/// values by 0. One limiter is for the force, another for the torque.
///
/// It cannot be switched off.
class ForceLimiter {
 public:
  /// What changed the force, as bits.
  enum Intervention : std::uint8_t {
    None = 0,
    Saturated = 1,
    Slewed = 2,
    NotFinite = 4,
    Damped = 8,   ///< set by the engine: damping was added against generated energy
    Active = 16,  ///< set by the engine: the scene has generated energy
    TorqueSaturated = 32,
    TorqueSlewed = 64,
    TorqueActive = 128,  ///< as Active, for the rotation about the tool's axis
  };

  struct Limited {
    double force = 0.0;  ///< [N]
    std::uint8_t interventions = None;
  };

  /// @throws std::invalid_argument  if maxForce or maxRate is not a positive finite number.
  explicit ForceLimiter(const SafetyLimits& limits);

  /// A limiter of a torque: its input and Limited::force are torques [N·m], and it sets the
  /// interventions of a torque.
  /// @throws std::invalid_argument  if maxTorque or maxTorqueRate is not a positive finite number.
  static ForceLimiter forTorque(const SafetyLimits& limits);

  /// Returns the allowed force nearest to @p desired [N], @p dt [s] after the last call; 0 if @p
  /// desired is not finite or @p dt not positive.
  Limited limit(double desired, double dt) noexcept;

  /// Sets the force to zero without a ramp: the next one starts from zero.
  void release() noexcept { last_ = 0.0; }

 private:
  ForceLimiter(double most, double rate, std::uint8_t saturated, std::uint8_t slewed);

  double largest_;
  double rate_;
  std::uint8_t saturationFlag_;  ///< the intervention that reports saturation
  std::uint8_t slewFlag_;        ///< the intervention that reports the slew limit
  double last_ = 0.0;
};

/// Computes the gain of the force, from 0 to 1: 0 during a fault, and 1 only after a soft start.
///
/// - The force starts softly after a new scene or a stop, and when the dead-man switch is held
///   again or the tool is slow again: the gain stays 0 until the scene's force is small, and then
///   rises to 1 over the ramp time.
/// - A missing sample is bridged by the last force for one tick; then the force fades.
/// - One missed period is bridged by the device itself. Several reduce the gain by as much as
///   fading would have done in that time; it then rises over the ramp.
class ForceGate {
 public:
  /// Why the gain is below 1, as bits.
  enum Reason : std::uint8_t {
    None = 0,
    TooFast = 1,          ///< the tool exceeds the limit of velocity
    DeadManReleased = 2,  ///< the dead-man switch is not held
    NoSample = 4,         ///< the device gave no new measurement
    MissedPeriods = 8,    ///< the clock missed more than one period
    SoftStart = 16        ///< waits for a small force, or the gain is rising
  };

  struct Input {
    bool isMeasured = true;     ///< there is a new sample
    bool isDeadManHeld = true;  ///< the dead-man switch is held
    double velocity = 0.0;      ///< [device's travel unit/s]
    double desired = 0.0;       ///< desired by the scene [N]
    int missedPeriods = 0;      ///< periods without a tick before this one
  };

  struct Output {
    double gain = 0.0;  ///< [0, 1]
    std::uint8_t reasons = None;
    bool isSilenceTooLong = false;  ///< no new sample for longer than SafetyLimits::longestSilence
  };

  explicit ForceGate(const SafetyLimits& limits) noexcept : limits_(limits) {}

  /// Advances by @p dt [s].
  Output step(const Input& input, double dt) noexcept;

  /// Sets the gain to 0 without a ramp; the next force starts softly.
  void close() noexcept;

  /// Lets the present force fade and the next one start softly.
  void startSoftly() noexcept { isWaiting_ = true; }

 private:
  std::uint8_t closingReasons(const Input& input, double dt) noexcept;

  SafetyLimits limits_;
  double gain_ = 0.0;
  double silence_ = 0.0;   ///< since the last measurement [s]
  bool isWaiting_ = true;  ///< waiting for a small force, before a soft start
};

}  // namespace haptics::engine
