#pragma once

#include <QStyledItemDelegate>
#include <QTableWidget>

namespace study::gui {

/// Gives wrapped words the height that they need within the padding of a cell, which Qt leaves out.
class WrappingDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    constexpr int kPadding = 8;  // [px] to each side
    auto narrower = option;
    narrower.rect.adjust(kPadding, 0, -kPadding, 0);
    return QStyledItemDelegate::sizeHint(narrower, index);
  }
};

/// For a table that only shows: nothing is edited, and Tab goes on to the next control. In Qt's own
/// tables Tab goes from cell to cell and never leaves (WCAG 2.1.2, no keyboard trap).
inline void makeReadOnly(QTableWidget& table) {
  table.setEditTriggers(QAbstractItemView::NoEditTriggers);
  table.setTabKeyNavigation(false);
  table.setItemDelegate(new WrappingDelegate(&table));
}

}  // namespace study::gui
