#pragma once

#include <QApplication>
#include <QMenu>

namespace study::gui {

/// Puts on what was chosen last; until somebody chooses, light or dark as the desktop is. To be
/// called before any theme is worn, since afterwards the desktop's colours cannot be seen.
void applyChosenTheme(QApplication& application);

/// A menu to choose from: as the desktop, light, dark, high contrast. A choice is worn at once and
/// remembered.
void addThemesTo(QMenu& menu);

}  // namespace study::gui
