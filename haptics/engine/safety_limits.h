#pragma once

#include <limits>

namespace haptics::engine {

/// What a hand may be made to feel, and how fast. Saturation, slew and the check for finiteness
/// cannot be switched off.
struct SafetyLimits {
  double maxForce = 3.0;   ///< [N], > 0
  double maxRate = 300.0;  ///< how fast a force may change [N/s], > 0

  /// A tool that is faster than this is in nobody's hand: no force [device's travel unit/s], > 0.
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

}  // namespace haptics::engine
