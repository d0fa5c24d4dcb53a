#include "study/gui/session/stop_key.h"

#include <utility>

#include <QApplication>
#include <QKeyEvent>
#include <QWidget>

namespace study::gui {

StopKey::StopKey(QObject* parent) : QObject(parent) {
  QApplication::instance()->installEventFilter(this);
}

bool StopKey::eventFilter(QObject* watched, QEvent* event) {
  const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
  if (!isArmed_ || !isKey) return QObject::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  auto* list = QApplication::activePopupWidget();
  // Escape closes an open list already at its ShortcutOverride event, which precedes the KeyPress
  // event; that KeyPress must then not stop the force. If a shortcut consumes the key, no KeyPress
  // event follows, and the flag must not affect the next Escape.
  if (key == Qt::Key_Escape && list != nullptr) {
    isForList_ = true;
    QMetaObject::invokeMethod(
        this, [this] { isForList_ = false; }, Qt::QueuedConnection);
  }
  if (event->type() == QEvent::ShortcutOverride) return false;
  if (key == Qt::Key_Escape && std::exchange(isForList_, false)) {
    if (list != nullptr) list->close();
    return true;
  }
  if (key != Qt::Key_Escape && key != Qt::Key_Pause && key != Qt::Key_F12) return false;
  emit pressed();
  return true;
}

}  // namespace study::gui
