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
  std::string folder;                      ///< folder for pictures; empty: none
};

/// The frame rate of a scene, and the lateness of the force loop meanwhile.
struct SimulationSpeed {
  std::string name;
  std::string remark;  ///< of the renderer, if there is one
  ViewReport view;
  TrialRecord felt;
  double making = 0.0;         ///< time to build the scene before the trial [ms]
  double bytesPerFrame = 0.0;  ///< on spheres, sent to the renderer
  double allBytes = 0.0;       ///< for all spheres; 0 without spheres

  /// Whether a frame sends only the changes: at most 5 % of the bytes.
  bool sendsChangesOnly() const { return bytesPerFrame <= 0.05 * allBytes; }
};

/// A simulated hand uses the punch in a knee, or the reamer in a cup. Frames of 1280 × 800 are
/// drawn as fast as possible. Needs a QApplication.
SimulationSpeed measureKnee(const SimulationOptions& options);
SimulationSpeed measureCup(const SimulationOptions& options);

}  // namespace study::bench
