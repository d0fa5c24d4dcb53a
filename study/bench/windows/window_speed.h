#pragma once

#include <optional>
#include <string>
#include <vector>

#include "protocols/reading/anatomy_file.h"
#include "study/gui/scene/hip_scene.h"
#include "study/gui/scene/renderer.h"
#include "study/model/trial_record.h"

namespace study::bench {

/// The speed of the operator's live plots: three channels at 1 kHz, a frame every 16 ms.
struct PlotSpeed {
  double picturesPerSecond = 0.0;
  double processor = 0.0;  ///< share of one processor
};
PlotSpeed measurePlots(double seconds);

/// The time from pressing Next until the next page is drawn, with the answers stored first: every
/// page of 20 sessions in which trials are skipped. The study is made in @p folder and removed.
/// @return the times [ms].
/// @throws UserError  if the folder cannot hold a study.
std::vector<double> measurePageChanges(const std::string& folder);

/// The time from making the home page until it is drawn, with @p studies studies in its list. The
/// studies are made in @p folder and removed. The program's settings are moved to that folder, too,
/// so call it last.
/// @return the time [ms].
/// @throws UserError  if the folder cannot hold the studies.
double measureHome(const std::string& folder, int studies);

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
  std::string
      remark;  ///< what the renderer says of itself, e.g. that it draws without a graphics card
  ViewReport view;
  TrialRecord felt;
  double making = 0.0;         ///< time to build the scene before the trial [ms]
  double bytesPerFrame = 0.0;  ///< bytes on spheres sent to the renderer per frame
  double allBytes = 0.0;       ///< for all spheres; 0 without spheres

  /// Whether a frame sends only the changes: at most 5 % of the bytes.
  bool sendsChangesOnly() const { return bytesPerFrame <= 0.05 * allBytes; }
};

/// A simulated hand uses the punch in a knee, or the reamer in a cup. Frames of 1280 × 800 are
/// drawn as fast as possible. Needs a QApplication.
SimulationSpeed measureKnee(const SimulationOptions& options);
SimulationSpeed measureCup(const SimulationOptions& options);

}  // namespace study::bench
