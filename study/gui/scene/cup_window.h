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

/// A bone for a researcher: coloured by how hard it is or by what the reamer has taken, with what
/// the colours mean. Still, or as a participant reams it.
class CupWindow final : public QWidget {
  Q_OBJECT

 public:
  /// The trial that is followed, asked for again and again: whether it goes on.
  struct Present {
    HipScene* seen = nullptr;  ///< by the participant; nothing: the trial is over
    bool isRunning = false;
  };
  using Trial = std::function<Present()>;

  /// @param trial  closes the window when it is over; none: a bone that stays as it is.
  CupWindow(const haptics::engine::PackingSpec& spec, Trial trial, QWidget* parent = nullptr);
  ~CupWindow() override;

  /// Colours that say nothing of this bone are not offered.
  void leaveOut(SphereColours colours);

  QSize sizeHint() const override { return {760, 600}; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void choose(int index);
  void follow();
  void showPicture(const QImage& picture);
  QSize pictureSize() const;

  Trial trial_;
  HipScene* heard_ = nullptr;  ///< whose changes are told here; the trial says when it goes
  DensityRange range_;
  QComboBox* colours_;
  QLabel* picture_;
  ColourLegend* legend_;
  CupPainter* painter_;
  QTimer look_;
};

}  // namespace study::gui::scene
