#include "study/report/page_layout.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <QAbstractTextDocumentLayout>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextLayout>
#include <QTextTable>

namespace study::report {
namespace {

constexpr double kLeastScale = 0.65;  // of a figure: smaller, its words are hard to read
constexpr int kFirstRows = 5;         // of a long table: with the rows of its head
constexpr double kSlack = 1.0;        // rounding of the layout [px]

/// A paragraph or a table of the document, from top to bottom.
struct Item {
  QTextBlock block;             ///< invalid for a table
  QTextTable* table = nullptr;  ///< nullptr for a paragraph
  double top = 0.0;
  double bottom = 0.0;        ///< its end
  double figureHeight = 0.0;  ///< of a paragraph with a figure
  double firstPart = 0.0;     ///< the end of what has to be on the page of its top
  bool isHeading = false;
  bool isFigure = false;

  /// Whether the next item belongs to it.
  bool keepsNext() const { return isHeading || isFigure; }
};

bool holdsFigure(const QTextBlock& block) {
  for (auto it = block.begin(); !it.atEnd(); ++it) {
    if (it.fragment().charFormat().objectType() == kFigure) return true;
  }
  return false;
}

Item itemOf(const QTextDocument& document, const QTextBlock& block) {
  const QRectF where = document.documentLayout()->blockBoundingRect(block);
  const auto* lines = block.layout();
  Item item{.block = block, .top = where.top(), .bottom = where.bottom()};
  item.isHeading = block.blockFormat().headingLevel() > 0;
  item.isFigure = holdsFigure(block);
  // A figure that does not fit is moved within its paragraph, which then is higher than it.
  if (item.isFigure && lines->lineCount() > 0) item.figureHeight = lines->lineAt(0).height();
  const bool isWhole = item.isHeading || item.isFigure || lines->lineCount() < 4;
  item.firstPart = isWhole ? item.bottom : item.top + lines->lineAt(1).rect().bottom();
  return item;
}

Item itemOf(const QTextDocument& document, QTextTable* table) {
  const auto* layout = document.documentLayout();
  const QRectF where = layout->frameBoundingRect(table);
  Item item{.table = table, .top = where.top(), .bottom = where.bottom()};
  if (where.height() < document.pageSize().height()) {
    item.firstPart = item.bottom;
    return item;
  }
  const int last = std::min(kFirstRows, table->rows()) - 1;
  const auto block = table->cellAt(last, 0).firstCursorPosition().block();
  item.firstPart = layout->blockBoundingRect(block).bottom();
  return item;
}

std::vector<Item> itemsOf(const QTextDocument& document) {
  std::vector<Item> items;
  auto* root = document.rootFrame();
  for (auto it = root->begin(); !it.atEnd(); ++it) {
    if (auto* table = qobject_cast<QTextTable*>(it.currentFrame())) {
      items.push_back(itemOf(document, table));
    } else if (it.currentBlock().isValid()) {
      items.push_back(itemOf(document, it.currentBlock()));
    }
  }
  return items;
}

bool beginsPage(const Item& item) {
  const auto policy = item.table != nullptr ? item.table->format().pageBreakPolicy()
                                            : item.block.blockFormat().pageBreakPolicy();
  return policy != QTextFormat::PageBreak_Auto;
}

void beginPage(const Item& item) {
  if (item.table != nullptr) {
    auto format = item.table->format();
    format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
    item.table->setFormat(format);
    return;
  }
  auto format = item.block.blockFormat();
  format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
  QTextCursor(item.block).setBlockFormat(format);
}

/// Shrinks the figure of a paragraph to @p factor of its size.
void shrink(const Item& item, double factor) {
  for (auto it = item.block.begin(); !it.atEnd(); ++it) {
    auto format = it.fragment().charFormat();
    if (format.objectType() != kFigure) continue;
    format.setProperty(kFigureScale, factor);
    QTextCursor cursor(item.block);
    cursor.setPosition(it.fragment().position());
    cursor.setPosition(it.fragment().position() + 1, QTextCursor::KeepAnchor);
    cursor.setCharFormat(format);
    return;
  }
}

bool isShrunk(const Item& item) {
  for (auto it = item.block.begin(); !it.atEnd(); ++it) {
    if (it.fragment().charFormat().hasProperty(kFigureScale)) return true;
  }
  return false;
}

/// Looks at the items that belong together from @p begin on. Returns whether it changed something.
bool mend(const std::vector<Item>& items, std::size_t begin, std::size_t end, double page) {
  const double bottom = (std::floor((items[begin].top + kSlack) / page) + 1.0) * page;
  if (items[end].firstPart <= bottom + kSlack) return false;
  for (std::size_t i = begin; i < end; ++i) {
    if (!items[i].isFigure || isShrunk(items[i])) continue;
    // The figure may lie on the next page by now; what follows it is as high there as here.
    const double top = items[i].top < bottom ? items[i].top : items[i - 1].bottom;
    const double below = items[end].firstPart - items[end].top;
    const double factor = (bottom - top - below) / items[i].figureHeight;
    if (factor < kLeastScale || factor >= 1.0) continue;
    shrink(items[i], 0.99 * factor);
    return true;
  }
  if (beginsPage(items[begin]) || begin == 0) return false;
  beginPage(items[begin]);
  return true;
}

}  // namespace

void layOutAgain(QTextDocument& document) {
  const QSizeF size = document.pageSize();
  document.setPageSize(size + QSizeF(1.0, 1.0));
  document.setPageSize(size);
}

void breakPages(QTextDocument& document) {
  const double page = document.pageSize().height();
  // What comes before a change stays where it is, so that each item is mended at most twice.
  for (std::size_t begin = 0;;) {
    const auto items = itemsOf(document);
    if (begin >= items.size()) return;
    std::size_t end = begin;
    while (end + 1 < items.size() && items[end].keepsNext()) ++end;
    if (mend(items, begin, end, page)) {
      layOutAgain(document);
      continue;
    }
    ++begin;  // what is left of a chain is looked at again: its heading may have filled a page
  }
}

}  // namespace study::report
