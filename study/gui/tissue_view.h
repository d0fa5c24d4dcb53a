#pragma once

#include <vector>

#include <QWidget>

#include "haptics/engine/compiled_scene.h"

namespace study::gui {

/// The punch and the tissue in it, drawn: the jaw follows the handle, the meniscus gives way as the
/// finite-element mesh says.
class TissueView final : public QWidget {
  Q_OBJECT

 public:
  explicit TissueView(QWidget* parent = nullptr);

  /// @param travel  of the handle [travel units].
  void show(double travel, std::vector<haptics::engine::MeshView::Point> mesh);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintTissue(QPainter& painter) const;
  void paintPunch(QPainter& painter) const;

  double travel_ = 0.0;
  std::vector<haptics::engine::MeshView::Point> mesh_;
};

}  // namespace study::gui
