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

#include "haptics/engine/bone_models.h"
#include "haptics/engine/scene_spec.h"
#include "study/gui/scene/shapes/bone_tints.h"

namespace study::gui::scene {

/// Draws a coloured bone for the operator in a background thread. The thread has a low priority so
/// that the haptic rendering and the participant's view come first. It draws at most 15 pictures a
/// second, half of the rate of the participant's view without a graphics card.
///
/// Call all functions from the GUI thread. Only the destructor blocks: it waits for the picture in
/// progress.
class BoneColoursPainter final : public QObject {
  Q_OBJECT

 public:
  using Changes = std::vector<haptics::engine::SphereChange>;

  /// @param pastChanges  the changes of the bone so far.
  BoneColoursPainter(
      const haptics::engine::PackingSpec& spec, Changes pastChanges, QObject* parent = nullptr);
  ~BoneColoursPainter() override;

  void choose(SphereColours colours) { next_.colours = colours; }
  void resize(QSize size) { next_.size = size.expandedTo({16, 16}); }
  /// Adds a change of a sphere.
  void addChange(const haptics::engine::SphereChange& change) { next_.changes.push_back(change); }
  /// Passes the latest changes and settings to the thread. Call it several times a second.
  /// @param depth  of the reamer, along its path [m].
  void submit(double depth, bool isRunning);

 signals:
  void painted(const QImage& picture);
  /// The densities at both ends of the colour scale.
  void measured(study::gui::scene::DensityRange range);
  /// Drawing failed with the message @p why, and stops.
  void failed(const QString& why);

 private:
  /// What to draw next.
  struct Request {
    SphereColours colours = SphereColours::Density;
    QSize size{640, 440};
    double depth =
        std::numeric_limits<double>::quiet_NaN();  ///< of the reamer [m]; NaN: not set yet
    bool isRunning = false;
    Changes changes;  ///< not drawn yet
  };
  class Bone;

  void work(const std::stop_token& stop);
  void paint(const std::stop_token& stop);
  void measure();
  void showPicture(const QImage& picture);

  const haptics::engine::PackingSpec spec_;
  Request next_;  ///< used by the GUI thread only
  std::mutex mutex_;
  std::condition_variable_any woken_;
  Request request_;          ///< guarded by mutex_
  bool hasChanges_ = false;  ///< guarded by mutex_
  std::jthread
      thread_;  // declared last, so that it is joined before the members that it uses are destroyed
};

}  // namespace study::gui::scene
