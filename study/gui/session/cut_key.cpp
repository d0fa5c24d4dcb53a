#include "study/gui/session/cut_key.h"

#include <QApplication>
#include <QKeyEvent>
#include <QWidget>

namespace study::gui {

CutKey::CutKey(QObject* parent) : QObject(parent) {
  QApplication::instance()->installEventFilter(this);
}

bool CutKey::eventFilter(QObject* watched, QEvent* event) {
  // A key reaches the filter for its window first, and then for the focused widget.
  if (event->type() != QEvent::KeyPress || !watched->isWidgetType()) return false;
  const auto* key = static_cast<QKeyEvent*>(event);
  if (key->key() != Qt::Key_F9) return false;
  if (!key->isAutoRepeat()) emit pressed();
  return true;
}

}  // namespace study::gui
