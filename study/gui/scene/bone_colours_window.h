#pragma once

#include <functional>

#include <QComboBox>
#include <QLabel>
#include <QPixmap>
#include <QTimer>
#include <QWidget>

#include "haptics/engine/scene_spec.h"
#include "study/gui/scene/bone_colours_painter.h"
#include "study/gui/scene/colour_legend.h"
#include "study/gui/scene/hip_scene.h"

namespace study::gui::scene {

/// Shows the operator a bone, coloured by density or by the material removed, with a legend. The
/// bone is either unchanged or follows a running trial.
class BoneColoursWindow final : public QWidget {
  Q_OBJECT

 public:
  /// The state of the trial that the window follows.
  struct FollowedTrial {
    HipScene* participantView = nullptr;  ///< the participant's view; nullptr: the trial is over
    bool isRunning = false;
  };
  using Trial = std::function<FollowedTrial()>;

  /// @param trial  returns the trial's state; the window closes when the trial is over. Empty: the
  /// bone does not change.
  BoneColoursWindow(
      const haptics::engine::PackingSpec& spec, Trial trial, QWidget* parent = nullptr);
  ~BoneColoursWindow() override;

  /// Removes a colouring from the choices.
  void removeColours(SphereColours colours);

  QSize sizeHint() const override { return {760, 600}; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void choose(int index);
  void updatePicture();
  void showPicture(const QImage& picture);
  QSize pictureSize() const;

  Trial trial_;
  HipScene* followed_ = nullptr;  ///< the view whose changes this window receives
  DensityRange range_;
  QComboBox* colours_;
  QLabel* picture_;
  ColourLegend* legend_;
  BoneColoursPainter* painter_;
  QTimer updateTimer_;
};

}  // namespace study::gui::scene
