#pragma once

#include <cstdint>
#include <limits>

namespace haptics::engine {

/// The largest force and its fastest change. Saturation, slew and the check for finiteness
/// cannot be switched off.
struct SafetyLimits {
  double maxForce = 3.0;   ///< [N], > 0
  double maxRate = 300.0;  ///< how fast a force may change [N/s], > 0

  double maxTorque = 5.0;       ///< about the tool's axis [N·m], > 0
  double maxTorqueRate = 50.0;  ///< how fast a torque may change [N·m/s], > 0

  /// A tool that is faster than this is in no hand: no force [device's travel unit/s], > 0.
  double maxVelocity = std::numeric_limits<double>::infinity();

  /// How long a force takes to come or to go where the gate opens or closes [s], > 0.
  double rampTime = 0.1;

  /// A force comes on only while the scene asks for less than this share of maxForce, in (0, 1].
  double quietShare = 0.1;

  /// How long a device may fail to deliver before it is stopped altogether [s], > 0.
  double patience = 0.1;

  /// Damps where the scene gives more energy than it was given; otherwise that is only reported.
  bool isPassivityControlled = false;
};

/// The last stage before the motors: saturates, limits the rate of change, refuses NaN. For a
/// force; a torque has a limiter of its own with its own limits.
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
    TorqueSaturated = 32,
    TorqueSlewed = 64,
    TorqueActive = 128,  ///< as Active, for the turn about the tool's axis
  };

  struct Limited {
    double force = 0.0;  ///< [N]
    std::uint8_t interventions = None;
  };

  /// @throws std::invalid_argument  if maxForce or maxRate is not a positive finite number.
  explicit ForceLimiter(const SafetyLimits& limits);

  /// Of a torque [N·m]. What it answers with is the same in that unit, and interventions are those
  /// of a torque.
  /// @throws std::invalid_argument  if maxTorque or maxTorqueRate is not a positive finite number.
  static ForceLimiter ofTorque(const SafetyLimits& limits);

  /// The nearest allowed force to @p desired [N], @p dt [s] after the last one.
  Limited limit(double desired, double dt) noexcept;

  /// Sets the force to zero without a ramp: the next one starts from zero.
  void release() noexcept { last_ = 0.0; }

 private:
  ForceLimiter(double most, double rate, std::uint8_t saturated, std::uint8_t slewed);

  double most_;
  double rate_;
  std::uint8_t saturated_;  ///< what it says where it has limited the size,
  std::uint8_t slewed_;     ///< and the rate
  double last_ = 0.0;
};

/// The gain of a force, from 0 to 1: 0 during a fault, and 1 only after a soft start.
///
/// - A new scene, and the time after a stop, start softly: no force until the scene asks for a
///   small force, then more and more over the ramp. So does a hand that takes the switch again, and
///   one that has become slow again.
/// - A sample that is missing is bridged by the last force for one tick; then the force fades.
/// - One missed period is bridged by the device itself; more than one fades the force by what
///   it should have faded since, and it comes back over the ramp.
class ForceGate {
 public:
  /// Why the gate is not all open, as bits.
  enum Reason : std::uint8_t {
    None = 0,
    TooFast = 1,        ///< the tool exceeds the limit of velocity
    Released = 2,       ///< the dead-man switch is not held
    NoSample = 4,       ///< the device gave no new measurement
    MissedPeriods = 8,  ///< the clock missed more than one period
    SoftStart = 16      ///< waits for a small force, or lets it come on
  };

  struct Input {
    bool isMeasured = true;  ///< there is a new sample
    bool isHeld = true;      ///< the dead-man switch is held
    double velocity = 0.0;   ///< [device's travel unit/s]
    double desired = 0.0;    ///< desired by the scene [N]
    int missedPeriods = 0;   ///< before this tick
  };

  struct Output {
    double gain = 0.0;  ///< [0, 1]
    std::uint8_t reasons = None;
    bool isPatienceOver = false;  ///< the device has failed to deliver for too long
  };

  explicit ForceGate(const SafetyLimits& limits) noexcept : limits_(limits) {}

  /// One step of @p dt [s].
  Output step(const Input& input, double dt) noexcept;

  /// Shuts without a ramp; the next force starts softly.
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
