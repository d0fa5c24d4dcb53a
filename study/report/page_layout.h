#pragma once

#include <vector>

#include <QLineF>
#include <QTextDocument>
#include <QTextFormat>

namespace study::report {

/// The object type of a figure in a QTextDocument.
inline constexpr int kFigure = QTextFormat::UserObject + 1;
/// Properties of a figure's character format: its index, and the factor (≤ 1) by which it is
/// shrunk; without the factor it has its own size.
inline constexpr int kFigureNumber = QTextFormat::UserProperty + 1;
inline constexpr int kFigureScale = QTextFormat::UserProperty + 2;

/// Gives the columns of each table the width of their longest cell. If the table is then too wide,
/// the widest columns share the width that the others leave. Qt's own layout also counts cells that
/// span columns, such as captions, and therefore wraps names beside empty space.
void fitColumns(QTextDocument& document);

/// A line across a table.
struct TableRule {
  QLineF line;
  double thickness = 0.0;  ///< [px of the paper]
};

/// The three rules of every table, in the document's coordinates: above and below its head, and
/// below its last row. The caption is above the first. They are no borders of cells: Qt repeats
/// those above a table that begins a page (Qt 6.4).
std::vector<TableRule> rulesOf(const QTextDocument& document);

/// Chooses where the pages of a document begin: a heading stays with what follows, a figure with
/// its caption. A figure that does not fit on the page is shrunk a little if that is enough. A
/// long table is divided between its groups of rows, or where several rows are on each page; what
/// is on the next page has the same head and is marked as @p continuationMark, in brackets.
void choosePageBreaks(QTextDocument& document, const QString& continuationMark);

/// Gives the entries of each list of contents, which follows a heading of the second level that
/// begins a page, the number of the page of their heading of the third level. Has to be called
/// before choosePageBreaks() with room for the numbers, and again after it.
void numberContents(QTextDocument& document);

/// Lays out the whole document. The partial layout that Qt does after a change leaves some blocks
/// undrawn (Qt 6.4).
void layOutAgain(QTextDocument& document);

}  // namespace study::report
