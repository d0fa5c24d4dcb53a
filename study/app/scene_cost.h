#pragma once

#include <string>
#include <vector>

#include "haptics/engine/scene_spec.h"
#include "haptics/timing/stopwatch.h"

namespace study::app {

/// The time of a scene's tick, alone or with an additional computation.
struct SceneCost {
  std::string what;
  haptics::timing::Timing time;  ///< [ns]
};

/// Measures a tick of @p spec, and again with each part that this scene lacks; that part's result
/// is computed but not used. All are measured in turn on this computer; the first result is the
/// scene itself. The tool moves back and forth over the travel of a device of @p kind.
std::vector<SceneCost> costsOf(
    const haptics::engine::SceneSpec& spec, const haptics::devices::DeviceKind& kind);

}  // namespace study::app
