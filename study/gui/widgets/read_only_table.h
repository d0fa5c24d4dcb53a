#pragma once

#include <QHeaderView>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QTableWidget>

#include "study/gui/widgets/theme.h"

namespace study::gui {

/// Draws a line below each cell, and gives cells the height that their wrapped text needs; Qt does
/// not count the padding.
class WrappingDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    constexpr int kPadding = 5;  // [px] to each side, as in the theme
    auto narrower = option;
    const int padding = option.widget == nullptr ? kPadding : scaled(*option.widget, kPadding);
    narrower.rect.adjust(padding, 0, -padding, 0);
    return QStyledItemDelegate::sizeHint(narrower, index);
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index)
      const override {
    // Below the theme's style of cells, their own background is not drawn.
    const auto ground = index.data(Qt::BackgroundRole);
    if (ground.isValid()) painter->fillRect(option.rect, ground.value<QBrush>());
    QStyledItemDelegate::paint(painter, option, index);
    if (option.widget == nullptr) return;
    painter->setPen(themeOf(*option.widget).line);
    painter->drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
  }
};

/// Makes a table read-only with lines between its rows, headings at the left and no row numbers,
/// and lets Tab move to the next control. In Qt's own tables Tab goes from cell to cell and never
/// leaves (WCAG 2.1.2, no keyboard trap).
inline void makeReadOnly(QTableWidget& table) {
  table.setEditTriggers(QAbstractItemView::NoEditTriggers);
  table.setTabKeyNavigation(false);
  table.setShowGrid(false);
  table.horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table.verticalHeader()->hide();
  table.setItemDelegate(new WrappingDelegate(&table));
}

}  // namespace study::gui
