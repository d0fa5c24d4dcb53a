#pragma once

#include <string>
#include <vector>

#include "haptics/engine/scene_spec.h"
#include "haptics/timing/stopwatch.h"

namespace study::app {

/// What a tick of a scene takes, alone or with something that it leaves out.
struct SceneCost {
  std::string what;
  haptics::timing::Timing time;  ///< [ns]
};

/// A tick of @p spec as it is, and then with each thing put in that this scene does without –
/// worked out and thrown away –, all in turn on this computer. The first is the scene itself.
/// The tool goes to and fro over the travel of a device of @p kind.
std::vector<SceneCost> costsOf(
    const haptics::engine::SceneSpec& spec, const haptics::devices::DeviceKind& kind);

}  // namespace study::app
