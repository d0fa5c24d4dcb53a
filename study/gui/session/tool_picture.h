#pragma once

#include <QImage>
#include <QWidget>

#include "haptics/devices/device_kind.h"

namespace study::gui {

/// A simulator has the handle of a punch, without its shaft and jaws.
enum class InstrumentIs { Real, Simulated };

/// A still picture of the instrument that a device represents, as it is held, with its shadow on a
/// card. It shows neither tissue nor an alternative. It is drawn a moment after the page has
/// appeared.
class ToolPicture final : public QWidget {
 public:
  /// @param device  must have a view.
  ToolPicture(
      const haptics::devices::DeviceKind& device,
      InstrumentIs instrument,
      QWidget* parent = nullptr);

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void draw();
  QImage drawn(const QColor& ground) const;

  haptics::devices::View view_;
  InstrumentIs instrument_;
  QImage picture_;
};

/// A card with the picture of the instrument; nullptr if there is no picture of it.
QWidget* toolCardOf(
    const haptics::devices::DeviceKind& device, InstrumentIs instrument, QWidget* parent);

}  // namespace study::gui
