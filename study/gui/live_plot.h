#pragma once

#include <QWidget>
#include <qcustomplot.h>

namespace study::gui {

/// Force and position over the last ten seconds, as they happen. One-pixel pens: a wider one makes
/// every picture many times dearer.
class LivePlot final : public QWidget {
  Q_OBJECT

 public:
  explicit LivePlot(QWidget* parent = nullptr);

  void clear();
  /// @param time [s], @param force [N], @param travel [device's travel unit]
  void add(double time, double force, double travel);
  /// Draws what was added.
  void refresh();

 private:
  QCustomPlot* plot_;
  double last_ = 0.0;
};

}  // namespace study::gui
