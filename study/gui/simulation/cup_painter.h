#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#include <QImage>
#include <QObject>
#include <QSize>

#include "haptics/engine/bone_view.h"
#include "haptics/engine/scene_spec.h"
#include "study/gui/simulation/bone_tints.h"

namespace study::gui::simulation {

/// Draws a cup in colours for a researcher, on a thread of its own that gets the processor where
/// nobody else wants it: whoever feels and sees the trial is served first. At most 15 pictures a
/// second, half of what a participant sees without a graphics card.
///
/// All calls come from the window's thread, and none of them waits.
class CupPainter final : public QObject {
  Q_OBJECT

 public:
  using Changes = std::vector<haptics::engine::SphereChange>;

  /// @param past  what has become of the bone until now.
  CupPainter(const haptics::engine::PackingSpec& spec, Changes past, QObject* parent = nullptr);
  ~CupPainter() override;

  void choose(SphereColours colours);
  void resize(QSize size);
  /// A sphere has changed.
  void tell(const haptics::engine::SphereChange& change) { untold_.push_back(change); }
  /// Hands on what has been told. @param depth  of the reamer, along its plunge [m].
  void handOn(double depth, bool isRunning);

 signals:
  void painted(const QImage& picture);
  /// What the ends of the colours of densities mean.
  void measured(study::gui::simulation::DensityRange range);

 private:
  /// What is to be drawn.
  struct Wish {
    SphereColours colours = SphereColours::Density;
    QSize size{640, 440};
    double depth = -0.02;  ///< [m]
    bool isRunning = false;
    Changes changes;  ///< since the last picture
  };
  class Cup;

  void work(const std::stop_token& stop);
  void measure();
  void showPicture(const QImage& picture);

  const haptics::engine::PackingSpec spec_;
  Changes untold_;  ///< the window's thread's own
  std::mutex mutex_;
  std::condition_variable_any woken_;
  Wish wish_;            ///< under the mutex
  bool hasNews_ = true;  ///< under the mutex
  std::jthread thread_;  // last: joined before what it uses goes
};

}  // namespace study::gui::simulation
