#pragma once

#include <QApplication>

namespace study::gui {

/// Calm colours, large targets, a visible focus: the same on every desktop.
void applyTheme(QApplication& application);

}  // namespace study::gui
