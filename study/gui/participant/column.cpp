#include "study/gui/participant/column.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QLayout>

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

double scaleFor(QSize size) noexcept {
  constexpr double kHeight = 800.0;  // [px] of a window with the scale 1
  constexpr double kWidth = 1024.0;
  constexpr double kSteps = 20.0;  // the scale changes in steps of 1/20, so that dragging an edge
                                   // does not restyle at every pixel
  const double wanted = std::min(size.height() / kHeight, size.width() / kWidth);
  return std::max(1.0, std::floor(wanted * kSteps) / kSteps);
}

void scaleDistances(QWidget& page, double ratio) {
  const auto scaledBy = [ratio](int length) {
    return static_cast<int>(std::lround(ratio * length));
  };
  for (auto* layout : page.findChildren<QLayout*>()) {
    const auto margins = layout->contentsMargins();
    layout->setContentsMargins(
        scaledBy(margins.left()),
        scaledBy(margins.top()),
        scaledBy(margins.right()),
        scaledBy(margins.bottom()));
    if (layout->spacing() > 0) layout->setSpacing(scaledBy(layout->spacing()));
  }
}

}  // namespace study::gui
