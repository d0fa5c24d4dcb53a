#pragma once

#include <QObject>

namespace study::gui {

/// The key that means no force at once, in whatever window of this program the focus is: Esc, Pause
/// or F12. A foot switch or a large button on the desk that types one of them is a stop as well.
class StopKey final : public QObject {
  Q_OBJECT

 public:
  /// Looks at every key from now on, and takes none while it is not armed.
  explicit StopKey(QObject* parent = nullptr);

  /// While a trial runs the keys mean stop and nothing else.
  void setArmed(bool isArmed) { isArmed_ = isArmed; }

  bool eventFilter(QObject* watched, QEvent* event) override;

 signals:
  void pressed();

 private:
  bool isArmed_ = false;
};

}  // namespace study::gui
