#include "study/report/page_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <QAbstractTextDocumentLayout>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocumentFragment>
#include <QTextLayout>
#include <QTextList>
#include <QTextTable>

namespace study::report {
namespace {

constexpr double kLeastScale = 0.93;  // of a figure: its letters are then 7 pt high
constexpr int kFirstRows = 6;         // of a divided table: with the rows of its head
constexpr int kLastRows = 4;
constexpr int kWholeRows = 9;       // of a table that is never divided: with the rows of its head
constexpr double kPadding = 4.0;    // beside a cell's text, as in print_html.cpp [px]
constexpr double kSlack = 1.0;      // rounding of the layout [px]
constexpr double kThickRule = 1.3;  // [px]
constexpr double kThinRule = 0.7;
constexpr double kRuleMargin = 1.5;  // between a table's text and its outer rules [px]

/// A paragraph or a table of the document, from top to bottom.
struct Item {
  QTextBlock block;             ///< for a table the empty block after it, if there is one
  QTextTable* table = nullptr;  ///< nullptr for a paragraph
  double top = 0.0;
  double bottom = 0.0;          ///< its end
  double figureHeight = 0.0;    ///< of a paragraph with a figure
  double firstPart = 0.0;       ///< the end of what has to be on the same page as its top
  std::optional<int> division;  ///< of a table: the row to continue with, see divisionOf()
  bool isHeading = false;
  bool isFigure = false;
  bool isEndOfList = false;  ///< see isBesideItem()

  /// Whether the next item has to be on the same page.
  bool keepsNext() const { return isHeading || isFigure || isEndOfList; }
};

/// The figure of a paragraph; not valid if it has none.
QTextFragment figureIn(const QTextBlock& block) {
  for (auto it = block.begin(); !it.atEnd(); ++it) {
    if (it.fragment().charFormat().objectType() == kFigure) return it.fragment();
  }
  return {};
}

/// Whether a paragraph is a note, which is about the table above: notes are grey (print_html.cpp).
bool isNote(const QTextBlock& block) {
  const auto first = block.begin();
  return !first.atEnd() && first.fragment().charFormat().foreground().color() == QColor(0x444444);
}

/// Whether a paragraph must be on the same page as the next one because of a list: no item of a
/// list may be alone on a page, and a note below a list stays with the list.
bool isBesideItem(const QTextBlock& block) {
  const auto* list = block.textList();
  if (list == nullptr) {
    const bool isIntroduction = block.text().endsWith(u':');
    return isIntroduction && block.next().isValid() && block.next().textList() != nullptr;
  }
  const int place = list->itemNumber(block);
  if (place == list->count() - 1) return block.next().isValid() && isNote(block.next());
  return place == 0 || place == list->count() - 2;
}

Item itemOf(const QTextDocument& document, const QTextBlock& block) {
  const QRectF where = document.documentLayout()->blockBoundingRect(block);
  const auto* lines = block.layout();
  Item item{.block = block, .top = where.top(), .bottom = where.bottom()};
  item.isHeading = block.blockFormat().headingLevel() > 0;
  item.isFigure = figureIn(block).isValid();
  item.isEndOfList = isBesideItem(block);
  // Qt moves a figure that does not fit down within its paragraph, which is then higher than the
  // figure.
  if (item.isFigure && lines->lineCount() > 0) item.figureHeight = lines->lineAt(0).height();
  const bool isWhole = item.isHeading || item.isFigure || lines->lineCount() < 4;
  item.firstPart = isWhole ? item.bottom : item.top + lines->lineAt(1).rect().bottom();
  return item;
}

bool spansColumns(const QTextTable& table, int row) {
  return table.columns() > 1 && table.cellAt(row, 0).columnSpan() == table.columns();
}

/// The row with which a table that crosses the end of its page is best continued on the next one:
/// the first of a group of rows, or, without groups, one that leaves several rows on each page;
/// std::nullopt if there is none, or if the table is on one page.
std::optional<int> divisionOf(const QTextDocument& document, const QTextTable& table) {
  const auto pageOf = [&](int row) {
    const auto block = table.cellAt(row, 0).firstCursorPosition().block();
    const double middle = document.documentLayout()->blockBoundingRect(block).center().y();
    return static_cast<int>(middle / document.pageSize().height());
  };
  if (table.rows() <= kWholeRows) return std::nullopt;
  int first = 1;  // of the next page
  while (first < table.rows() && pageOf(first) == pageOf(0)) ++first;
  if (first == table.rows()) return std::nullopt;
  int group = std::min(first, table.rows() - kLastRows);
  while (group > kFirstRows - 2 && !spansColumns(table, group)) --group;
  if (group >= kFirstRows - 1) return group;
  int begin = first;  // of the group that the page divides
  while (begin > 1 && !spansColumns(table, begin)) --begin;
  int end = first;
  while (end < table.rows() && !spansColumns(table, end)) ++end;
  const bool isInGroup = spansColumns(table, begin);
  const int above = isInGroup ? first - begin : first - kFirstRows + kLastRows;
  return above < kLastRows || end - first < kLastRows ? std::nullopt : std::optional(first);
}

/// Copies a cell with its format and text.
void copyCell(const QTextTableCell& from, QTextTableCell to) {
  to.setFormat(from.format());
  auto cursor = to.firstCursorPosition();
  cursor.setBlockFormat(from.firstCursorPosition().blockFormat());
  auto content = from.firstCursorPosition();
  content.setPosition(from.lastPosition(), QTextCursor::KeepAnchor);
  cursor.insertFragment(content.selection());
}

/// Moves the rows of a table from @p row on to a table of their own on the next page.
void divide(QTextTable& table, int row, const QString& continuationMark) {
  const int heads = table.format().headerRowCount();
  const int moved = table.rows() - row;
  QTextCursor cursor(table.document());
  cursor.setPosition(table.lastPosition() + 1);
  auto format = table.format();
  format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
  auto* next = cursor.insertTable(heads + moved, table.columns(), format);
  for (int i = 0; i < heads + moved; ++i) {
    const int source = i < heads ? i : row + i - heads;
    for (int column = 0; column < table.columns(); ++column) {
      const auto cell = table.cellAt(source, column);
      if (cell.column() != column) continue;  // covered by one that spans columns
      if (cell.columnSpan() > 1) next->mergeCells(i, column, 1, cell.columnSpan());
      copyCell(cell, next->cellAt(i, column));
    }
  }
  next->cellAt(0, 0).lastCursorPosition().insertText(QStringLiteral(" (%1)").arg(continuationMark));
  table.removeRows(row, moved);
}

Item itemOf(const QTextDocument& document, QTextTable* table) {
  const auto* layout = document.documentLayout();
  QRectF where = layout->frameBoundingRect(table);
  const auto after = document.findBlock(table->lastPosition() + 1);
  const bool isEmpty = after.isValid() && after.length() == 1;
  if (isEmpty) {
    // Qt reports the rows too low by a cell's padding. It draws the empty block after a table
    // beside the last row, or, before another table, below that row.
    const QRectF empty = layout->blockBoundingRect(after);
    const bool isBelow = QTextCursor(after.next()).currentTable() != nullptr;
    where.translate(0.0, (isBelow ? empty.top() : empty.bottom()) - where.bottom());
  }
  Item item{.table = table, .top = where.top(), .bottom = where.bottom()};
  if (isEmpty) item.block = after;
  item.firstPart = item.bottom;
  item.division = divisionOf(document, *table);
  if (!item.division) return item;
  const auto block = table->cellAt(*item.division - 1, 0).firstCursorPosition().block();
  item.firstPart = layout->blockBoundingRect(block).bottom();
  return item;
}

/// The width of the longest line of a cell that is not wrapped.
double widthOf(const QTextTableCell& cell) {
  double width = 0.0;
  for (auto it = cell.begin(); !it.atEnd(); ++it) {
    if (it.currentBlock().isValid()) {
      width = std::max(width, it.currentBlock().layout()->maximumWidth());
    }
  }
  return width;
}

/// Narrows the widest columns to one width, so that the sum of all widths is @p most.
void narrowWidestColumns(std::vector<double>& widths, double most) {
  std::vector<double> sorted = widths;
  std::ranges::sort(sorted);
  double left = most;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double share = left / static_cast<double>(sorted.size() - i);
    if (sorted[i] > share) {
      for (auto& width : widths) width = std::min(width, share);
      return;
    }
    left -= sorted[i];
  }
}

void fitColumns(QTextTable& table, double page, double padding) {
  std::vector<double> widths(static_cast<std::size_t>(table.columns()), 0.0);
  double spanning = 0.0;
  for (int row = 0; row < table.rows(); ++row) {
    for (int column = 0; column < table.columns(); ++column) {
      const auto cell = table.cellAt(row, column);
      const double width = 1.02 * widthOf(cell) + 2.0 * padding;
      auto& widest = cell.columnSpan() > 1 ? spanning : widths[static_cast<std::size_t>(column)];
      widest = std::max(widest, width);
    }
  }
  narrowWidestColumns(widths, page);
  double sum = 0.0;
  for (const double width : widths) sum += width;
  const double room = std::max(0.0, std::min(spanning, page) - sum) / table.columns();
  QList<QTextLength> shares;
  for (double& width : widths) {
    width += room;
    shares.append(
        QTextLength(QTextLength::PercentageLength, 100.0 * width / (sum + room * table.columns())));
  }
  auto format = table.format();
  format.setWidth(
      QTextLength(QTextLength::PercentageLength, 100.0 * (sum + room * table.columns()) / page));
  format.setColumnWidthConstraints(shares);
  table.setFormat(format);
}

/// The upper and the lower end of the text in a row.
std::pair<double, double> textExtentOf(const QTextTable& table, int row) {
  const auto* layout = table.document()->documentLayout();
  std::pair ends(std::numeric_limits<double>::max(), 0.0);
  for (int column = 0; column < table.columns(); ++column) {
    const auto cell = table.cellAt(row, column);
    const auto first = layout->blockBoundingRect(cell.firstCursorPosition().block());
    const auto last = layout->blockBoundingRect(cell.lastCursorPosition().block());
    ends = {std::min(ends.first, first.top()), std::max(ends.second, last.bottom())};
  }
  return ends;
}

/// Where the rule above a row is: between its text and that of the row before.
double edgeAbove(const QTextTable& table, int row) {
  const double margin =
      kRuleMargin * table.document()->documentLayout()->paintDevice()->logicalDpiY() / 96.0;
  if (row == 0) return textExtentOf(table, 0).first - margin;
  const double above = textExtentOf(table, row - 1).second;
  if (row < table.rows()) return 0.5 * (above + textExtentOf(table, row).first);
  // the rule below the last row stays on its page
  const double page = table.document()->pageSize().height();
  return std::min(above + margin, (std::floor((above - kSlack) / page) + 1.0) * page - margin);
}

std::vector<Item> itemsOf(const QTextDocument& document) {
  std::vector<Item> items;
  auto* root = document.rootFrame();
  for (auto it = root->begin(); !it.atEnd(); ++it) {
    if (auto* table = qobject_cast<QTextTable*>(it.currentFrame())) {
      items.push_back(itemOf(document, table));
    } else if (const auto block = it.currentBlock(); block.isValid()) {
      const bool isOfTable =
          !items.empty() && items.back().table != nullptr && items.back().block == block;
      if (isOfTable) continue;
      const bool isCaption = !items.empty() && items.back().isFigure;
      items.push_back(itemOf(document, block));
      if (isCaption) items.back().firstPart = items.back().bottom;  // it is never divided
    }
  }
  return items;
}

bool breaksPage(const Item& item) {
  const auto policy = item.table != nullptr ? item.table->format().pageBreakPolicy()
                                            : item.block.blockFormat().pageBreakPolicy();
  return policy != QTextFormat::PageBreak_Auto;
}

bool beginsPage(const Item& item, double page) {
  return breaksPage(item) || std::fmod(item.top + kSlack, page) < 2.0 * kSlack;
}

void setPageBreak(const Item& item, QTextFormat::PageBreakFlag policy) {
  if (item.table != nullptr) {
    auto format = item.table->format();
    format.setPageBreakPolicy(policy);
    item.table->setFormat(format);
    return;
  }
  auto format = item.block.blockFormat();
  format.setPageBreakPolicy(policy);
  QTextCursor(item.block).setBlockFormat(format);
}

/// Shrinks the figure of a paragraph to @p factor of its size.
void shrink(const Item& item, double factor) {
  const auto figure = figureIn(item.block);
  if (!figure.isValid()) return;
  auto format = figure.charFormat();
  format.setProperty(kFigureScale, factor);
  QTextCursor cursor(item.block);
  cursor.setPosition(figure.position());
  cursor.setPosition(figure.position() + 1, QTextCursor::KeepAnchor);
  cursor.setCharFormat(format);
}

bool isShrunk(const Item& item) {
  const auto figure = figureIn(item.block);
  return figure.isValid() && figure.charFormat().hasProperty(kFigureScale);
}

double headHeightOf(const QTextTable& table) {
  const auto topOf = [&](int row) {
    const auto block = table.cellAt(row, 0).firstCursorPosition().block();
    return table.document()->documentLayout()->blockBoundingRect(block).top();
  };
  return topOf(table.format().headerRowCount() - 1) - topOf(0);
}

/// Shrinks the figure before a table, if the table then fits on the same page.
bool shrinkFigureBefore(const std::vector<Item>& items, std::size_t table, double bottom) {
  if (table < 2 || items[table].table == nullptr || !items[table - 2].isFigure) return false;
  const auto& figure = items[table - 2];
  // on one page the table needs its head only once
  const double excess = items[table].bottom - bottom - headHeightOf(*items[table].table);
  const double factor = 1.0 - excess / figure.figureHeight;
  const bool isHelpful = excess < items[table].bottom - items[table].top && factor >= kLeastScale;
  if (!isHelpful || isShrunk(figure)) return false;
  shrink(figure, 0.99 * factor);
  return true;
}

/// Begins a page after a table that ends just above the end of its page. Qt rounds the position of
/// the block after a table to 1/64 of a page and therefore puts it on the next page, although it is
/// still on this one: its lines are cut at the page's end, and a page break leaves an empty page
/// (Qt 6.4). Returns whether it changed something.
bool beginPageAfterTable(const std::vector<Item>& items, std::size_t at, double page) {
  const auto& block = items[at].block;
  if (items[at].table == nullptr || !block.isValid() || at + 1 == items.size()) return false;
  const double left = page - std::fmod(items[at].bottom, page);
  if (left > page / 128.0 + kSlack) return false;
  auto format = block.blockFormat();
  const auto* paper = block.document()->documentLayout()->paintDevice();
  format.setTopMargin(left);  // applies if a table follows; Qt does not scale it
  format.setBottomMargin(left * 96.0 / paper->logicalDpiY());  // applies if a paragraph follows
  QTextCursor(block).setBlockFormat(format);
  setPageBreak(items[at + 1], QTextFormat::PageBreak_Auto);
  return true;
}

/// The height between a figure and the text of its caption. The line that holds a figure is a
/// little higher than the figure, also if the figure is shrunk.
double gapBelow(const Item& figure, const Item& caption) {
  constexpr double kLine = 5.0;  // [px]
  const double dpi = figure.block.document()->documentLayout()->paintDevice()->logicalDpiY();
  const double margin =
      std::max(figure.block.blockFormat().bottomMargin(), caption.block.blockFormat().topMargin());
  return dpi / 96.0 * (margin + kLine);
}

/// Whether the page before an item's page break has more than 40 % of its height left and is not
/// the first page.
bool leavesRoom(const std::vector<Item>& items, std::size_t at, double page) {
  if (at == 0 || !breaksPage(items[at])) return false;
  const double before = items[at - 1].bottom / page;
  return before > 1.0 && before - std::floor(before) < 0.6;
}

/// Puts the items from @p begin to @p end, which belong together, on one page: shrinks a figure, or
/// begins a page. Returns whether it changed something.
bool keepTogether(const std::vector<Item>& items, std::size_t begin, std::size_t end, double page) {
  const double bottom = (std::floor((items[begin].top + kSlack) / page) + 1.0) * page;
  if (items[end].firstPart <= bottom + kSlack) return false;
  for (std::size_t i = begin; i < end; ++i) {
    if (!items[i].isFigure || isShrunk(items[i])) continue;
    // The figure may be on the next page now. What follows it has the same height there.
    const double top = items[i].top < bottom ? items[i].top : items[i - 1].bottom;
    const double below = items[end].firstPart - items[end].top + gapBelow(items[i], items[i + 1]);
    const double factor = (bottom - top - below) / items[i].figureHeight;
    if (factor < kLeastScale || factor >= 1.0) continue;
    shrink(items[i], 0.99 * factor);
    return true;
  }
  if (beginsPage(items[begin], page) || begin == 0) return false;
  if (shrinkFigureBefore(items, begin, bottom)) return true;
  setPageBreak(items[begin], QTextFormat::PageBreak_AlwaysBefore);
  return true;
}

/// Puts the note of a table on the page on which the table ends: begins a page before the last
/// rows, or before the table. Returns whether it changed something.
bool keepNote(
    const std::vector<Item>& items, std::size_t at, double page, const QString& continuationMark) {
  auto* table = items[at].table;
  if (table == nullptr || at + 1 == items.size() || items[at + 1].table != nullptr) return false;
  if (!isNote(items[at + 1].block) || breaksPage(items[at + 1])) return false;
  const double bottom = (std::floor((items[at].bottom - kSlack) / page) + 1.0) * page;
  if (items[at + 1].bottom <= bottom + kSlack) return false;
  int row = table->rows() - kLastRows + 1;
  bool hasGroups = false;
  for (int i = 0; i < table->rows(); ++i) hasGroups = hasGroups || spansColumns(*table, i);
  while (hasGroups && row >= kFirstRows - 1 && !spansColumns(*table, row)) --row;
  if (row >= kFirstRows - 1) {
    divide(*table, row, continuationMark);
    return true;
  }
  while (at > 0 && items[at - 1].keepsNext()) --at;  // a heading goes with its table
  if (beginsPage(items[at], page)) return false;
  setPageBreak(items[at], QTextFormat::PageBreak_AlwaysBefore);
  return true;
}

}  // namespace

void fitColumns(QTextDocument& document) {
  const auto* paper = document.documentLayout()->paintDevice();
  auto* root = document.rootFrame();
  for (auto* frame : root->childFrames()) {
    auto* table = qobject_cast<QTextTable*>(frame);
    if (table == nullptr) continue;
    fitColumns(*table, document.pageSize().width(), kPadding * paper->logicalDpiX() / 72.0);
  }
  layOutAgain(document);
}

std::vector<TableRule> rulesOf(const QTextDocument& document) {
  const double px = document.documentLayout()->paintDevice()->logicalDpiY() / 96.0;
  std::vector<TableRule> rules;
  for (auto* frame : document.rootFrame()->childFrames()) {
    const auto* table = qobject_cast<QTextTable*>(frame);
    if (table == nullptr) continue;
    const QRectF where = document.documentLayout()->frameBoundingRect(frame);
    const auto add = [&](double y, double thickness) {
      rules.push_back({{where.left(), y, where.right(), y}, thickness * px});
    };
    const int heads = table->format().headerRowCount();
    const bool hasCaption = heads > 1;  // see moveCaptionsIntoHeads() in print_html.cpp
    add(edgeAbove(*table, hasCaption ? 1 : 0), kThickRule);
    if (heads > 0 && heads < table->rows()) add(edgeAbove(*table, heads), kThinRule);
    add(edgeAbove(*table, table->rows()), kThickRule);
  }
  return rules;
}

void layOutAgain(QTextDocument& document) {
  const QSizeF size = document.pageSize();
  document.setPageSize(size + QSizeF(1.0, 1.0));
  document.setPageSize(size);
}

void choosePageBreaks(QTextDocument& document, const QString& continuationMark) {
  const double page = document.pageSize().height();
  auto items = itemsOf(document);
  const auto layOut = [&] {
    layOutAgain(document);
    items = itemsOf(document);
  };
  // A change does not move the items before it, so each item is changed at most three times.
  for (std::size_t begin = 0, lastChecked = 0; begin < items.size();) {
    // Removes a break that leaves too much of a page empty. Breaks set by this loop are not
    // checked.
    if (begin > lastChecked && leavesRoom(items, begin, page)) {
      setPageBreak(items[begin], QTextFormat::PageBreak_Auto);
      layOut();
      lastChecked = begin;
      continue;
    }
    lastChecked = begin;
    std::size_t end = begin;
    while (end + 1 < items.size() && items[end].keepsNext()) ++end;
    if (keepTogether(items, begin, end, page)) {
      layOut();
      continue;
    }
    if (items[begin].division) {
      const double bottom = (std::floor((items[begin].top + kSlack) / page) + 1.0) * page;
      if (shrinkFigureBefore(items, begin, bottom)) {
        layOut();
        continue;
      }
      divide(*items[begin].table, *items[begin].division, continuationMark);
      layOut();
    }
    if (keepNote(items, begin, page, continuationMark)) layOut();
    if (beginPageAfterTable(items, begin, page)) layOut();
    ++begin;  // the rest of a chain is checked again: its heading may have filled a page
  }
}

void numberContents(QTextDocument& document) {
  const double page = document.pageSize().height();
  std::vector<QTextBlock> entries;
  bool isInContents = false;
  std::size_t next = 0;  // the entry whose heading comes next
  for (auto block = document.begin(); block.isValid(); block = block.next()) {
    const auto format = block.blockFormat();
    if (format.headingLevel() == 2) {
      entries.clear();
      next = 0;
      isInContents = true;
    } else if (isInContents && block.textList() != nullptr) {
      entries.push_back(block);
    } else if (format.headingLevel() == 3) {
      isInContents = false;
      if (next == entries.size()) continue;
      const double top = document.documentLayout()->blockBoundingRect(block).center().y();
      QTextCursor entry(entries[next++]);
      entry.movePosition(QTextCursor::EndOfBlock);
      auto own = entry.blockFormat();
      const double scale = document.documentLayout()->paintDevice()->logicalDpiX() / 96.0;
      const double indent = document.indentWidth() * (entry.currentList()->format().indent() + 1);
      if (own.tabPositions().isEmpty()) {
        own.setTabPositions({QTextOption::Tab(
            document.pageSize().width() / scale - indent, QTextOption::RightTab)});
        entry.setBlockFormat(own);
      } else {
        const auto tab = entry.block().text().lastIndexOf(u'\t');
        entry.setPosition(
            entry.block().position() + static_cast<int>(tab), QTextCursor::KeepAnchor);
      }
      entry.insertText(QStringLiteral("\t%1").arg(static_cast<int>(top / page) + 1));
    }
  }
  layOutAgain(document);
}

}  // namespace study::report
