#pragma once

#include <QSize>
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

/// The scale of the participant's pages in a window of @p size [px]: 1 on a laptop, growing with
/// the window: text is 23 px high on 1920 × 1080, and 46 px on 3840 × 2160.
double scaleFor(QSize size) noexcept;

/// Scales the distances in a page that was made at another scale.
void scaleDistances(QWidget& page, double ratio);

}  // namespace study::gui
