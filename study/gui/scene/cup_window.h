#pragma once

#include <functional>

#include <QComboBox>
#include <QLabel>
#include <QPixmap>
#include <QTimer>
#include <QWidget>

#include "haptics/engine/scene_spec.h"
#include "study/gui/scene/colour_legend.h"
#include "study/gui/scene/cup_painter.h"
#include "study/gui/scene/hip_scene.h"

namespace study::gui::scene {

/// Shows the operator a bone, coloured by density or by the material removed, with a legend. The
/// bone is either unchanged or follows a running trial.
class CupWindow final : public QWidget {
  Q_OBJECT

 public:
  /// The state of the trial that the window follows.
  struct Present {
    HipScene* seen = nullptr;  ///< the participant's view; nullptr: the trial is over
    bool isRunning = false;
  };
  using Trial = std::function<Present()>;

  /// @param trial  returns the trial's state, and the window closes when the trial is over; empty:
  /// the bone does not change.
  CupWindow(const haptics::engine::PackingSpec& spec, Trial trial, QWidget* parent = nullptr);
  ~CupWindow() override;

  /// Removes a colouring from the choices.
  void removeColours(SphereColours colours);

  QSize sizeHint() const override { return {760, 600}; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void choose(int index);
  void follow();
  void showPicture(const QImage& picture);
  QSize pictureSize() const;

  Trial trial_;
  HipScene* followed_ = nullptr;  ///< whose changes it receives
  DensityRange range_;
  QComboBox* colours_;
  QLabel* picture_;
  ColourLegend* legend_;
  CupPainter* painter_;
  QTimer look_;
};

}  // namespace study::gui::scene
