#pragma once

#include <QFrame>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QTimer>

#include "study/gui/session/operator_pin.h"

namespace study::gui {

/// Keeps the participant's window in front of everything else: full screen, without a frame, with
/// the keyboard grabbed, and raised again when another window comes to the front. A small button in
/// its corner asks for the operator's PIN, which unlocks the window.
///
/// A desktop may still handle some keys itself (Ctrl+Alt+F1 opens a console).
/// docs/running-a-study.md describes the settings for that.
class ScreenLock final : public QObject {
  Q_OBJECT

 public:
  /// @param button  asks for the PIN; visible while locked. Window, button and PIN must outlive the
  /// lock.
  ScreenLock(QWidget& window, QPushButton& button, OperatorPin& pin);

  bool isLocked() const noexcept { return isLocked_; }
  void lock();

  bool eventFilter(QObject* watched, QEvent* event) override;

 signals:
  /// The right PIN was entered. The window is a normal window again.
  void opened();

 private:
  void ask();
  void tryPin();
  void open();
  void closeDialog();
  void cover(bool isCovering);
  void grabKeyboard();

  QWidget& window_;
  QPushButton& button_;
  OperatorPin& pin_;
  QPointer<QFrame> pinSheet_;
  QPointer<QLineEdit> digits_;
  QPointer<QLabel> answer_;
  QTimer grabTimer_;  ///< retries the keyboard grab until it succeeds, which needs a visible window
  int tries_ = 0;
  bool isLocked_ = false;
};

}  // namespace study::gui
