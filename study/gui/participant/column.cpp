#include "study/gui/participant/column.h"

#include <QHBoxLayout>

#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {

constexpr int kSide = 20;  // [px] at scale 1, left and right of the column
constexpr int kBar = 14;   // width of a scroll bar in the style sheet

}  // namespace

QVBoxLayout* addColumn(QWidget& page, ColumnWidth width, ColumnIn in) {
  auto* across = new QHBoxLayout(&page);
  const int side = scaled(page, kSide);
  const int besideBar = in == ColumnIn::Scroll ? scaled(page, kSide - kBar) : side;
  const bool isMirrored = page.layoutDirection() == Qt::RightToLeft;
  across->setContentsMargins(isMirrored ? besideBar : side, 0, isMirrored ? side : besideBar, 0);
  auto* column = new QWidget(&page);
  column->setProperty(
      "role", width == ColumnWidth::Text ? QStringLiteral("column") : QStringLiteral("page"));
  constexpr int kFirst = 1000;  // stretch; both sides share what the column leaves free
  across->addStretch(1);
  across->addWidget(column, kFirst);
  across->addStretch(1);
  auto* rows = new QVBoxLayout(column);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(scaled(page, 12));
  return rows;
}

}  // namespace study::gui
