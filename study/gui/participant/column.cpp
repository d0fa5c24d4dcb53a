#include "study/gui/participant/column.h"

#include <QHBoxLayout>

#include "study/gui/widgets/theme.h"

namespace study::gui {

QVBoxLayout* addColumn(QWidget& page) {
  auto* across = new QHBoxLayout(&page);
  across->setContentsMargins(0, 0, 0, 0);
  auto* column = new QWidget(&page);
  column->setProperty("role", QStringLiteral("column"));
  constexpr int kFirst = 1000;  // stretch; both sides share what the column leaves free
  across->addStretch(1);
  across->addWidget(column, kFirst);
  across->addStretch(1);
  auto* rows = new QVBoxLayout(column);
  const int side = scaled(page, 6);  // keeps focus frames and the scroll bar apart
  rows->setContentsMargins(side, 0, side, 0);
  rows->setSpacing(scaled(page, 16));
  return rows;
}

}  // namespace study::gui
