#pragma once

#include <QObject>

namespace study::gui {

/// The keys that switch the force off at once in every window of the program: Esc, Pause and F12. A
/// foot switch or a large button that types one of these keys works as well.
class StopKey final : public QObject {
  Q_OBJECT

 public:
  /// Filters all key events from now on. While it is not armed it consumes none.
  explicit StopKey(QObject* parent = nullptr);

  /// While armed, which is during a trial, these keys do nothing but stop.
  void setArmed(bool isArmed) { isArmed_ = isArmed; }

  bool eventFilter(QObject* watched, QEvent* event) override;

 signals:
  void pressed();

 private:
  bool isArmed_ = false;
  bool isForList_ = false;  ///< the Escape key event in progress closes an open list
};

}  // namespace study::gui
