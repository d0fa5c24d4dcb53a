#pragma once

#include <QObject>

namespace study::gui {

/// The key that counts a cut with the physical tool in every window of the program, also while the
/// participant's window covers the screen: F9, or a foot switch that types it.
class CutKey final : public QObject {
  Q_OBJECT

 public:
  /// Filters all key events from now on.
  explicit CutKey(QObject* parent = nullptr);

  bool eventFilter(QObject* watched, QEvent* event) override;

 signals:
  void pressed();
};

}  // namespace study::gui
