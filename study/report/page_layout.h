#pragma once

#include <QTextDocument>
#include <QTextFormat>

namespace study::report {

/// A text object of a document that is a figure.
inline constexpr int kFigure = QTextFormat::UserObject + 1;
/// Its number, and how far it is shrunk: a factor up to 1, or nothing.
inline constexpr int kFigureNumber = QTextFormat::UserProperty + 1;
inline constexpr int kFigureScale = QTextFormat::UserProperty + 2;

/// Gives the columns of each table the width of their longest cell; where that is too wide, the
/// widest columns share what the others leave. Qt also counts cells that span columns, captions
/// among them, and wraps names beside empty room.
void fitColumns(QTextDocument& document);

/// Chooses where the pages of a document begin: a heading stays with what follows, a figure with
/// its caption. A figure that does not fit below the text is shrunk a little where that is enough.
/// A table is divided only if some rows are on each page, none of them a heading of rows below.
void breakPages(QTextDocument& document);

/// Lays out the whole document. The partial layout that Qt does after a change leaves some blocks
/// undrawn (Qt 6.4).
void layOutAgain(QTextDocument& document);

}  // namespace study::report
