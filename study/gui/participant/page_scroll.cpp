#include "study/gui/participant/page_scroll.h"

#include <QScrollBar>

namespace study::gui {

PageScroll::PageScroll(QWidget* parent) : QScrollArea(parent) {
  setWidgetResizable(true);
  setFocusPolicy(Qt::StrongFocus);  // the keyboard scrolls
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* bar = verticalScrollBar();
  bar->setEnabled(false);  // and invisible, by the style sheet
  connect(bar, &QScrollBar::rangeChanged, bar, [bar](int least, int most) {
    bar->setEnabled(most > least);
  });
}

bool PageScroll::hasMoreBelow() const {
  const auto* bar = verticalScrollBar();
  return bar->value() < bar->maximum();
}

}  // namespace study::gui
