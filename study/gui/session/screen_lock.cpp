#include "study/gui/session/screen_lock.h"

#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QVBoxLayout>
#include <QWindow>

#include "study/gui/widgets/labels.h"

namespace study::gui {

ScreenLock::ScreenLock(QWidget& window, QPushButton& button, OperatorPin& pin)
    : QObject(&window), window_(window), button_(button), pin_(pin) {
  button_.hide();
  // A click does not move the focus there: a space that is typed later would ask for the PIN.
  button_.setFocusPolicy(Qt::TabFocus);
  window_.installEventFilter(this);
  connect(&button_, &QPushButton::clicked, this, &ScreenLock::ask);
  constexpr int kTryInterval = 100;  // [ms]
  grabTimer_.setInterval(kTryInterval);
  connect(&grabTimer_, &QTimer::timeout, this, &ScreenLock::grabKeyboard);
}

void ScreenLock::lock() {
  isLocked_ = true;
  button_.show();
  cover(true);
}

/// Covers the whole screen, or makes the window a normal one again.
void ScreenLock::cover(bool isCovering) {
  window_.setWindowFlag(Qt::WindowStaysOnTopHint, isCovering);
  window_.setWindowFlag(Qt::FramelessWindowHint, isCovering);
  isCovering ? window_.showFullScreen() : window_.showNormal();
  if (isCovering) {
    window_.activateWindow();
    grabTimer_.start();
    return;
  }
  grabTimer_.stop();
  if (auto* handle = window_.windowHandle()) handle->setKeyboardGrabEnabled(false);
}

/// Retries because a desktop grants a keyboard grab only to a visible window. Some desktops never
/// grant it.
void ScreenLock::grabKeyboard() {
  auto* handle = window_.windowHandle();
  constexpr int kMostTries = 50;
  if (handle == nullptr || !handle->isExposed()) return;
  if (handle->setKeyboardGrabEnabled(true) || ++tries_ >= kMostTries) {
    grabTimer_.stop();
    tries_ = 0;
  }
}

bool ScreenLock::eventFilter(QObject* watched, QEvent* event) {
  if (!isLocked_) return QObject::eventFilter(watched, event);
  const bool isOurTurn = QApplication::activeModalWidget() == nullptr;
  if (event->type() == QEvent::WindowDeactivate && isOurTurn) {
    window_.raise();
    window_.activateWindow();
  }
  // The window was resized: close the question, which would no longer be in the middle.
  if (event->type() == QEvent::Resize && pinSheet_ != nullptr) closeDialog();
  return QObject::eventFilter(watched, event);
}

void ScreenLock::ask() {
  if (pinSheet_ != nullptr) return;
  pinSheet_ = new QFrame(&window_);
  pinSheet_->setProperty("role", QStringLiteral("card"));
  auto* layout = withMargins<QVBoxLayout>(pinSheet_, {28, 24, 28, 24});
  layout->addWidget(bodyLabel(tr("Only for the researcher: the PIN, please."), pinSheet_));
  digits_ = new QLineEdit(pinSheet_);
  digits_->setEchoMode(QLineEdit::Password);
  digits_->setMaxLength(OperatorPin::kMostDigits);
  digits_->setAccessibleName(tr("PIN of the researcher"));
  layout->addWidget(digits_);
  answer_ = quietLabel({}, pinSheet_);
  layout->addWidget(answer_);
  auto* buttons = new QHBoxLayout;
  auto* back = new QPushButton(tr("Back"), pinSheet_);
  auto* open = new QPushButton(tr("Open"), pinSheet_);
  buttons->addWidget(back);
  buttons->addStretch(1);
  buttons->addWidget(open);
  layout->addLayout(buttons);
  connect(back, &QPushButton::clicked, this, &ScreenLock::closeDialog);
  connect(open, &QPushButton::clicked, this, &ScreenLock::tryPin);
  connect(digits_, &QLineEdit::returnPressed, this, &ScreenLock::tryPin);
  constexpr int kWide = 460;
  pinSheet_->setFixedWidth(kWide);
  pinSheet_->adjustSize();
  pinSheet_->move(window_.rect().center() - pinSheet_->rect().center());
  pinSheet_->show();
  pinSheet_->raise();
  digits_->setFocus();
}

void ScreenLock::tryPin() {
  const bool isRight = pin_.acceptsPin(digits_->text());
  digits_->clear();
  if (isRight) {
    open();
  } else if (pin_.secondsUntilNextTry() > 0) {
    answer_->setText(tr("That is not the PIN. Please wait %1 s.").arg(pin_.secondsUntilNextTry()));
  } else {
    answer_->setText(tr("That is not the PIN."));
  }
}

void ScreenLock::open() {
  closeDialog();
  isLocked_ = false;
  button_.hide();
  cover(false);
  emit opened();
}

void ScreenLock::closeDialog() {
  if (pinSheet_ == nullptr) return;
  pinSheet_->hide();
  pinSheet_->deleteLater();
  pinSheet_ = nullptr;
}

}  // namespace study::gui
