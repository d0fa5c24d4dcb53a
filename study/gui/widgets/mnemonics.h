#pragma once

#include <QApplication>
#include <QWidget>

namespace study::gui {

/// Gives every button, tab, labelled field and menu entry of @p window that has none a mnemonic:
/// the letter that Alt and a key choose it by. Letters are those of the words that are shown, so
/// they follow the language; each stands for one text in the window as long as there are letters.
/// Nothing is done to pages for participants (disableMnemonics()).
void giveMnemonics(QWidget& window);

/// Does that to each window and menu when it is shown, and when its texts change.
void offerMnemonics(QApplication& application);

/// Leaves @p page and all in it without mnemonics.
void disableMnemonics(QWidget& page);

/// The mnemonic of a text, as a capital letter; null if it has none.
QChar mnemonicOf(const QString& text);

}  // namespace study::gui
