#pragma once

#include <QVBoxLayout>
#include <QWidget>

namespace study::gui {

/// Gives @p page a column in the middle, as wide as text is easily read: up to about 75 characters.
QVBoxLayout* addColumn(QWidget& page);

}  // namespace study::gui
