#pragma once

#include <QImage>
#include <QWidget>

#include "haptics/devices/device_kind.h"

namespace study::gui {

/// A still picture of the instrument that a device represents, from the side, as it is held. It
/// shows neither tissue nor an alternative. It is drawn a moment after the page has appeared.
class ToolPicture final : public QWidget {
 public:
  explicit ToolPicture(QWidget* parent = nullptr);

  /// Whether there is a picture of the instrument.
  static bool isKnown(const haptics::devices::DeviceKind& device) noexcept;

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void draw();

  QImage picture_;
};

}  // namespace study::gui
