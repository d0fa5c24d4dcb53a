#pragma once

#include <optional>
#include <string>

#include "protocols/reading/anatomy_file.h"
#include "study/gui/scene/hip_scene.h"
#include "study/gui/scene/renderer.h"
#include "study/model/trial_record.h"
#include "study/model/view_report.h"

namespace study::bench {

struct SimulationOptions {
  double seconds = 8.0;  ///< of each simulation
  std::size_t spheres = 201'532;
  gui::scene::RendererChoice renderer = gui::scene::RendererChoice::Best;
  gui::scene::SphereColours colours = gui::scene::SphereColours::Neutral;
  std::optional<protocols::Anatomy> knee;  ///< in place of the built-in one
  std::string folder;                      ///< for pictures; empty: none
};

/// How fast a simulation was drawn, and how well the hand was served meanwhile.
struct SimulationSpeed {
  std::string name;
  std::string remark;  ///< of who draws, where there is one
  ViewReport view;
  TrialRecord felt;
  double making = 0.0;         ///< of the scene, before the trial [ms]
  double bytesPerFrame = 0.0;  ///< about spheres, handed to who draws
  double allBytes = 0.0;       ///< of all spheres; 0 where there are none

  /// A picture hands on what has changed, not all: at most 5 % of the bytes.
  bool handsOnChangesOnly() const { return bytesPerFrame <= 0.05 * allBytes; }
};

/// A simulated hand at work with the punch in a knee; or with the reamer in a cup. Pictures of
/// 1280 × 800 are drawn as fast as possible. Needs a QApplication.
SimulationSpeed measureKnee(const SimulationOptions& options);
SimulationSpeed measureCup(const SimulationOptions& options);

}  // namespace study::bench
