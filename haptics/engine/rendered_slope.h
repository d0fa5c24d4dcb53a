#pragma once

#include <optional>

#include "haptics/devices/device_kind.h"
#include "haptics/engine/passivity.h"
#include "haptics/engine/scene_spec.h"

namespace haptics::engine {

/// How steep a scene is as it is rendered, tick by tick: the K of eq. (25) of the punch paper.
struct RenderedSlope {
  double steepest = 0.0;  ///< K: the largest |ΔF| / |Δx| of two ticks [N per travel unit]
  /// K follows from the model's equations and holds for every motion. Otherwise it is the largest
  /// of the sweep below, and another motion may be steeper.
  bool isProved = false;
  double largestStepAtRest = 0.0;  ///< the largest |ΔF| at Δx = 0, while it settles or after [N]
  std::optional<LimitCycle> limitCycle;  ///< the largest that was found on a resting hand
};

/// K of @p spec on a device of @p kind at @p rate [Hz].
///
/// Where the model is a function of travel whose slope has a bound, that bound. Otherwise (a
/// filter, a curve that ends in a jump) the scene is felt along a sweep of the device's whole
/// travel and what lies up to a twentieth beyond, or to the end of the scene's data:
///
/// - rest at 40 places, 0.4 s at each, reached while closing and while opening at 10 units/s;
/// - 0.1 and 1 unit/s at the same places, 0.25 s there and back;
/// - 10 and 45 units/s all the way, in and out of the recording, and with a reversal after every
///   tenth of it.
///
/// Units are those that people read (DeviceKind::TravelDisplay): travel units of the punch, mm of a
/// reamer. After 0.2 s of rest a force that still spans more than 1 mN is a limit cycle.
RenderedSlope renderedSlope(const SceneSpec& spec, const devices::DeviceKind& kind, double rate);

}  // namespace haptics::engine
