#pragma once

#include <QVBoxLayout>
#include <QWidget>

namespace study::gui {

/// Adds a centred column to @p page, up to about 75 characters wide so that text is easy to read.
QVBoxLayout* addColumn(QWidget& page);

}  // namespace study::gui
