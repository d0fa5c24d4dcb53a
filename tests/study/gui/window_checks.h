#pragma once

#include <functional>

#include <QSize>
#include <QStringList>
#include <QWidget>

namespace tests {

/// What keeps people from using a window, one line each; an empty list if nothing does. The window
/// must be shown and active. Every check also looks at what is inside scroll areas.

/// Texts whose glyphs have a contrast below @p least on what is behind them, as painted (WCAG
/// 1.4.3); the frame of a control does not count. Each drop-down list and each menu is opened, and
/// each of its entries is looked at with the cursor on it.
QStringList unreadableTexts(QWidget& window, double least);

/// Controls and texts that are cut off, do not have the room that their words need, or lie outside
/// of the window at @p size. What can be scrolled to from above or below is not cut off.
QStringList cutOffAt(QWidget& window, QSize size);

/// Controls that Tab does not reach, or from which it does not go on (WCAG 2.1.1 and 2.1.2); stops
/// that Shift+Tab visits in another order; stops at which the focus is not seen with a contrast
/// of 3.
QStringList lostFocus(QWidget& window);

/// Elements that a screen reader can focus, without a name for it to say (WCAG 4.1.2).
QStringList unnamedElements(QWidget& window);

/// The buttons, tabs, labelled fields and menu entries of @p window that no letter with Alt
/// chooses, and those of a menu that share a letter.
QStringList textsWithoutMnemonic(QWidget& window);

/// Buttons to the right of a dialog's action, a first focus where nothing can be entered, and stops
/// from which Tab goes up.
QStringList outOfOrder(QWidget& dialog);

}  // namespace tests
