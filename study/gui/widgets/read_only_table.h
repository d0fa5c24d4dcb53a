#pragma once

#include <QStyledItemDelegate>
#include <QTableWidget>

namespace study::gui {

/// Gives cells the height that their wrapped text needs; Qt does not count the padding.
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

/// Makes a table read-only, and lets Tab move to the next control. In Qt's own tables Tab goes from
/// cell to cell and never leaves (WCAG 2.1.2, no keyboard trap).
inline void makeReadOnly(QTableWidget& table) {
  table.setEditTriggers(QAbstractItemView::NoEditTriggers);
  table.setTabKeyNavigation(false);
  table.setItemDelegate(new WrappingDelegate(&table));
}

}  // namespace study::gui
