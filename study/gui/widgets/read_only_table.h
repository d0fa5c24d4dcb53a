#pragma once

#include <QTableWidget>

namespace study::gui {

/// For a table that only shows: nothing is edited, and Tab goes on to the next control. In Qt's own
/// tables Tab goes from cell to cell and never leaves (WCAG 2.1.2, no keyboard trap).
inline void makeReadOnly(QTableWidget& table) {
  table.setEditTriggers(QAbstractItemView::NoEditTriggers);
  table.setTabKeyNavigation(false);
}

}  // namespace study::gui
