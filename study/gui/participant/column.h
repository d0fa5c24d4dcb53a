#pragma once

#include <QVBoxLayout>
#include <QWidget>

namespace study::gui {

enum class ColumnWidth {
  Text,  ///< up to about 75 characters, so that text is easy to read
  Page,  ///< the width of a page, which is limited on a very wide screen
};

enum class ColumnIn {
  Window,
  Scroll,  ///< in a scroll area that always leaves room for its bar
};

/// Adds a centred column to @p page. With and without a scroll bar it has the same place.
QVBoxLayout* addColumn(
    QWidget& page, ColumnWidth width = ColumnWidth::Text, ColumnIn in = ColumnIn::Window);

}  // namespace study::gui
