#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "protocols/reading/anatomy_file.h"
#include "study/gui/scene/hip_scene.h"
#include "study/gui/scene/renderer.h"
#include "study/model/trial_record.h"

namespace study::bench {

/// The speed of the operator's live plots: three channels at 1 kHz, a frame every 16 ms.
struct PlotSpeed {
  double picturesPerSecond = 0.0;
  double processor = 0.0;  ///< processor time as a share of one processor
};
PlotSpeed measurePlots(double seconds);

/// The times from pressing Next until the next page is drawn, including the storing of answers, for
/// every page of 20 sessions in which trials are skipped. The study is created in @p folder and
/// removed.
/// @return the times [ms].
/// @throws UserError  if the folder cannot hold a study.
std::vector<double> measurePageChanges(const std::string& folder);

/// The time from creating the home page until it is drawn, with @p studies studies in its list. The
/// studies are created in @p folder and removed. Also moves the program's settings to that folder,
/// so call it last.
/// @return the time [ms].
/// @throws UserError  if the folder cannot hold the studies.
double measureHome(const std::string& folder, int studies);

/// The options of measureKnee() and measureCup().
struct SimulationOptions {
  double seconds = 8.0;                 ///< of each simulation
  std::pair<int, int> size{1280, 800};  ///< width and height of the window [pixels]
  std::size_t spheres = 201'532;
  gui::scene::RendererChoice renderer = gui::scene::RendererChoice::Best;
  gui::scene::SphereColours colours = gui::scene::SphereColours::Neutral;
  std::optional<protocols::Anatomy> knee;  ///< replaces the built-in one
  std::string folder;                      ///< folder for images; empty: none
};

/// The frame rate of a scene, and the lateness of the force loop meanwhile.
struct SimulationSpeed {
  std::string name;
  std::string remark;  ///< description of the renderer, e.g. that it draws without a graphics card
  ViewReport view;
  TrialRecord trialRecord;
  std::pair<int, int> size;    ///< size of the picture, which is scaled to the window [pixels]
  double longest = 0.0;        ///< the longest time from frame to frame [ms]
  double buildTime = 0.0;      ///< time to build the scene before the trial [ms]
  double bytesPerFrame = 0.0;  ///< number of bytes on spheres that a frame sends to the renderer
  double allBytes = 0.0;       ///< number of bytes on all spheres; 0 without spheres

  /// Whether a frame sends only changed spheres: at most 5 % of the bytes of all spheres.
  bool sendsChangesOnly() const { return bytesPerFrame <= 0.05 * allBytes; }
};

/// A simulated hand uses the punch in a knee, or the reamer in a cup. Frames are drawn as
/// fast as possible. Needs a QApplication.
SimulationSpeed measureKnee(const SimulationOptions& options);
SimulationSpeed measureCup(const SimulationOptions& options);

}  // namespace study::bench
