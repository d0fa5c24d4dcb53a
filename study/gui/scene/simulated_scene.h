#pragma once

#include <cstdint>

#include "haptics/engine/compiled_scene.h"
#include "study/gui/scene/scene.h"

namespace study::gui::scene {

/// What is known of a trial when a picture is drawn.
struct Look {
  double travel = 0.0;          ///< [device's travel unit]
  double force = 0.0;           ///< [N]
  bool isCutThrough = false;    ///< what the tool closes on has given way
  bool isRunning = false;       ///< a trial is under way
  std::int64_t sampleTime = 0;  ///< when the device was read [ns on CLOCK_MONOTONIC]; 0: never
  const haptics::engine::MeshView* mesh = nullptr;  ///< of the trial's scene, where it has one
  haptics::engine::BoneView* bone = nullptr;        ///< of the trial's scene, where it has one
};

/// A scene that follows a trial.
class SimulatedScene {
 public:
  virtual ~SimulatedScene() = default;
  SimulatedScene() = default;
  SimulatedScene(const SimulatedScene&) = delete;
  SimulatedScene& operator=(const SimulatedScene&) = delete;

  /// Brings everything to where it is now, @p seconds after the last time.
  virtual void follow(const Look& look, double seconds) = 0;

  virtual const Scene& scene() const noexcept = 0;
};

}  // namespace study::gui::scene
