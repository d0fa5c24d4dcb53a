#include "study/gui/widgets/fitting_scroll.h"

#include <QEvent>

namespace study::gui {

FittingScroll::FittingScroll(QWidget* inside, QWidget* parent) : QScrollArea(parent) {
  setFocusPolicy(Qt::NoFocus);  // it scrolls to what has the focus
  setWidget(inside);
  inside->installEventFilter(this);
}

void FittingScroll::fit() {
  const QSize least = widget()->minimumSizeHint().expandedTo(widget()->minimumSize());
  widget()->resize(viewport()->size().expandedTo(least));
}

void FittingScroll::resizeEvent(QResizeEvent* event) {
  fit();
  QScrollArea::resizeEvent(event);
}

bool FittingScroll::eventFilter(QObject* watched, QEvent* event) {
  if (watched == widget() && event->type() == QEvent::LayoutRequest) fit();
  return QScrollArea::eventFilter(watched, event);
}

QScrollArea* scrolled(QWidget* inside, QWidget* parent) {
  auto* scroll = new QScrollArea(parent);
  scroll->setWidgetResizable(true);
  scroll->setWidget(inside);
  scroll->setFocusPolicy(Qt::NoFocus);
  return scroll;
}

}  // namespace study::gui
