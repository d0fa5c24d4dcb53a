#pragma once

#include <QFrame>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QTimer>

#include "study/gui/session/operator_pin.h"

namespace study::gui {

/// Keeps a window in front of everything else while somebody else than the operator sits at the
/// screen: whole screen, no frame, the keyboard its own, and back in front when something else
/// comes there. A small button in its corner asks for the operator's PIN, and opens it.
///
/// A desktop may still keep a key of its own (Ctrl+Alt+F1 leads to a console):
/// docs/running-a-study.md says what to set there.
class ScreenLock final : public QObject {
  Q_OBJECT

 public:
  /// @param button  what asks for the PIN; shown while locked. Window, button and PIN outlive it.
  ScreenLock(QWidget& window, QPushButton& button, OperatorPin& pin);

  bool isLocked() const noexcept { return isLocked_; }
  void lock();

  bool eventFilter(QObject* watched, QEvent* event) override;

 signals:
  /// The PIN was right; the window is an ordinary one again.
  void opened();

 private:
  void ask();
  void tryPin();
  void open();
  void putAway();
  void cover(bool isCovering);
  void grabKeyboard();

  QWidget& window_;
  QPushButton& button_;
  OperatorPin& pin_;
  QPointer<QFrame> sheet_;
  QPointer<QLineEdit> digits_;
  QPointer<QLabel> answer_;
  QTimer grab_;  ///< until the keyboard is ours: not before the window is there
  int tries_ = 0;
  bool isLocked_ = false;
};

}  // namespace study::gui
