#pragma once

#include <QApplication>
#include <QWidget>

namespace study::gui {

/// Gives a mnemonic to every button, tab, labelled field and menu entry of @p window that has none:
/// the letter that chooses it together with Alt. The letter is one of the shown text, so it depends
/// on the language; texts share a letter only if there are too few letters. Pages for participants
/// are left out (disableMnemonics()).
void addMnemonics(QWidget& window);

/// Calls addMnemonics() for each window and menu when it is shown and when its texts change.
void installMnemonics(QApplication& application);

/// Excludes @p page and its children from mnemonics.
void disableMnemonics(QWidget& page);

/// The mnemonic of a text, as a capital letter; null if it has none.
QChar mnemonicOf(const QString& text);

}  // namespace study::gui
