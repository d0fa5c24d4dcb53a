#pragma once

#include <cstdint>

#include "haptics/engine/compiled_scene.h"
#include "study/gui/scene/scene.h"

namespace study::gui::scene {

/// The state of a trial when a picture is drawn.
struct TrialSnapshot {
  double travel = 0.0;          ///< [device's travel unit]
  double force = 0.0;           ///< [N]
  bool isCutThrough = false;    ///< the tissue between the jaws is cut
  bool isRunning = false;       ///< whether a trial is running
  std::int64_t sampleTime = 0;  ///< time of the device's sample [ns on CLOCK_MONOTONIC]; 0: none
  const haptics::engine::MeshView* mesh =
      nullptr;                                ///< of the trial's scene; nullptr if it has none
  haptics::engine::BoneView* bone = nullptr;  ///< of the trial's scene; nullptr if it has none
};

/// A scene that shows the state of a trial.
class SimulatedScene {
 public:
  virtual ~SimulatedScene() = default;
  SimulatedScene() = default;
  SimulatedScene(const SimulatedScene&) = delete;
  SimulatedScene& operator=(const SimulatedScene&) = delete;

  /// Moves everything to the current state, @p seconds after the previous call.
  virtual void update(const TrialSnapshot& snapshot, double seconds) = 0;

  virtual const Scene& scene() const noexcept = 0;
};

}  // namespace study::gui::scene
