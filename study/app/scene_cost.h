#pragma once

#include <string>
#include <vector>

#include "haptics/engine/scene_spec.h"
#include "haptics/timing/stopwatch.h"

namespace study::app {

/// The time of a tick of a scene, alone or with additional work.
struct SceneCost {
  std::string what;              ///< what was measured: the scene alone, or with which work
  haptics::timing::Timing time;  ///< of a tick [ns]
};

/// Measures a tick of @p spec alone, and with each kind of work that the scene lacks, whose result
/// is not used; for a scene with spheres, variants of the scene instead. Measurements alternate on
/// this computer. The first result is the scene alone. The tool moves back and forth over the
/// travel of a device of @p kind.
std::vector<SceneCost> measureCosts(
    const haptics::engine::SceneSpec& spec, const haptics::devices::DeviceKind& kind);

}  // namespace study::app
