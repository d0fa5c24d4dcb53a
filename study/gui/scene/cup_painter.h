#pragma once

#include <condition_variable>
#include <limits>
#include <mutex>
#include <thread>
#include <vector>

#include <QImage>
#include <QObject>
#include <QSize>
#include <QString>

#include "haptics/engine/bone_view.h"
#include "haptics/engine/scene_spec.h"
#include "study/gui/scene/shapes/bone_tints.h"

namespace study::gui::scene {

/// Draws a cup in colours for a researcher, on a thread of its own that stands back where others
/// want the processor: whoever feels and sees the trial is served first. At most 15 pictures a
/// second, half of what a participant sees without a graphics card.
///
/// All calls come from the window's thread, and none of them waits but the end: for the picture
/// under way.
class CupPainter final : public QObject {
  Q_OBJECT

 public:
  using Changes = std::vector<haptics::engine::SphereChange>;

  /// @param past  what has become of the bone until now.
  CupPainter(const haptics::engine::PackingSpec& spec, Changes past, QObject* parent = nullptr);
  ~CupPainter() override;

  void choose(SphereColours colours) { next_.colours = colours; }
  void resize(QSize size) { next_.size = size.expandedTo({16, 16}); }
  /// A sphere has changed.
  void tell(const haptics::engine::SphereChange& change) { next_.changes.push_back(change); }
  /// Hands on all that has been said: again and again, several times a second.
  /// @param depth  of the reamer, along its plunge [m].
  void handOn(double depth, bool isRunning);

 signals:
  void painted(const QImage& picture);
  /// What the ends of the colours of densities mean.
  void measured(study::gui::scene::DensityRange range);
  /// Nothing more will be painted: why, in words.
  void failed(const QString& why);

 private:
  /// What is to be drawn.
  struct Wish {
    SphereColours colours = SphereColours::Density;
    QSize size{640, 440};
    double depth = std::numeric_limits<double>::quiet_NaN();  ///< [m]; NaN: nothing wished yet
    bool isRunning = false;
    Changes changes;  ///< since the last picture
  };
  class Cup;

  void work(const std::stop_token& stop);
  void paint(const std::stop_token& stop);
  void measure();
  void showPicture(const QImage& picture);

  const haptics::engine::PackingSpec spec_;
  Wish next_;  ///< the window's thread's own
  std::mutex mutex_;
  std::condition_variable_any woken_;
  Wish wish_;             ///< under the mutex
  bool hasNews_ = false;  ///< under the mutex
  std::jthread thread_;   // last: joined before what it uses goes
};

}  // namespace study::gui::scene
