#include "study/gui/session/stop_key.h"

#include <QApplication>
#include <QKeyEvent>

namespace study::gui {

StopKey::StopKey(QObject* parent) : QObject(parent) {
  QApplication::instance()->installEventFilter(this);
}

bool StopKey::eventFilter(QObject* watched, QEvent* event) {
  if (!isArmed_ || event->type() != QEvent::KeyPress) return QObject::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key != Qt::Key_Escape && key != Qt::Key_Pause && key != Qt::Key_F12) return false;
  if (key == Qt::Key_Escape && QApplication::activePopupWidget() != nullptr) return false;
  emit pressed();
  return true;
}

}  // namespace study::gui
