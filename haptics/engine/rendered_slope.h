#pragma once

#include <optional>

#include "haptics/devices/device_kind.h"
#include "haptics/engine/passivity.h"
#include "haptics/engine/scene_spec.h"

namespace haptics::engine {

/// The slope of a scene as rendered tick by tick: K of eq. (25) of the punch paper.
struct RenderedSlope {
  enum class Basis {
    Proved,   ///< K follows from the model's equations and holds for every motion
    Sampled,  ///< K is the largest slope between closely spaced travels; closer ones may give more
    Swept,    ///< K is the largest in the sweep of renderedSlope(); another motion may give more
  };

  /// K: the largest |ΔF| / |Δx| between two ticks, without jitter [N per travel unit]
  double steepest = 0.0;
  Basis basis = Basis::Swept;
  /// RMS of the noise that the scene adds to the force, also on a hand that rests [N]. It is not
  /// part of K and of the fields below: no damping takes it up.
  double jitter = 0.0;
  double largestStepAtRest = 0.0;        ///< the largest |ΔF| between two ticks at Δx = 0 [N]
  std::optional<LimitCycle> limitCycle;  ///< the largest that was found with a resting hand
};

/// Determines K of @p spec on a device of @p kind at @p rate [Hz].
///
/// If the model has a slopeBound(), K is that bound. Otherwise (a filter, a curve that begins or
/// ends in a jump) the scene is rendered along a sweep of the device's range of travel, or from the
/// first jump and up to the end of the scene's data if these are farther, extended by 5 %:
///
/// - rest for 0.4 s at 40 positions, reached at 10 units/s while closing and while opening;
/// - 0.1 and 1 unit/s at the same positions, for 0.25 s forth and back;
/// - 10 and 45 units/s over the whole range, in and out, and with a reversal after every tenth of
///   it.
///
/// "Units" are the displayed ones (DeviceKind::TravelDisplay): travel units of the punch, mm of a
/// reamer. A force that still oscillates by more than 1 mN after 0.2 s of rest is a limit cycle.
RenderedSlope renderedSlope(const SceneSpec& spec, const devices::DeviceKind& kind, double rate);

}  // namespace haptics::engine
