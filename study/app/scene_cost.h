#pragma once

#include <string>
#include <vector>

#include "haptics/engine/scene_spec.h"
#include "haptics/timing/stopwatch.h"

namespace study::app {

/// The time of a scene's tick, alone or with something that the scene does without.
struct SceneCost {
  std::string what;
  haptics::timing::Timing time;  ///< [ns]
};

/// Measures a tick of @p spec, and again with the additional cost of each part that this scene
/// lacks; the result of that part is computed and not used. All are measured in turn on this
/// computer; the first is the scene itself. The tool moves back and forth over the travel of a
/// device of @p kind.
std::vector<SceneCost> costsOf(
    const haptics::engine::SceneSpec& spec, const haptics::devices::DeviceKind& kind);

}  // namespace study::app
