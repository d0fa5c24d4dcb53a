#pragma once

#include <QTextDocument>
#include <QTextFormat>

namespace study::report {

/// A text object of a document that is a figure.
inline constexpr int kFigure = QTextFormat::UserObject + 1;
/// Its number, and how far it is shrunk: a factor up to 1, or nothing.
inline constexpr int kFigureNumber = QTextFormat::UserProperty + 1;
inline constexpr int kFigureScale = QTextFormat::UserProperty + 2;

/// Chooses where the pages of a document begin: a heading stays with what follows, a figure with
/// its caption, and a table that fits on a page is on one. A figure that does not fit below the
/// text is shrunk a little where that is enough. Of a longer table, its first rows stay together.
void breakPages(QTextDocument& document);

/// Lays out the whole document. The partial layout that Qt does after a change leaves some blocks
/// undrawn (Qt 6.4).
void layOutAgain(QTextDocument& document);

}  // namespace study::report
