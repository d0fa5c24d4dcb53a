#include "study/gui/widgets/result_table.h"

#include <algorithm>

#include <QHeaderView>
#include <QKeyEvent>
#include <QScrollBar>

#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/read_only_table.h"

namespace study::gui {
namespace {

QString textOf(const Cell& cell) {
  const auto* text = std::get_if<std::string>(&cell);
  return text == nullptr ? QString() : asText(*text);
}

QString firstOf(const std::vector<Cell>& row) {
  return textOf(row.front());
}

/// Whether rows that follow each other begin with the same words.
bool isGrouped(const DataTable& table) {
  constexpr std::size_t kFewestColumns = 3;  // of two, the first is needed beside the second
  return table.columns.size() >= kFewestColumns && table.columns.front().isFreeText &&
         std::ranges::adjacent_find(table.rows, {}, firstOf) != table.rows.end();
}

/// The first column after the second that is not the same for all rows of each group. The columns
/// before it are shown once, in a heading above the rows of the group.
std::size_t firstOwnColumn(const DataTable& table) {
  constexpr std::size_t kFirst = 2;
  for (std::size_t column = kFirst; column < table.columns.size(); ++column) {
    const bool isShared =
        std::ranges::adjacent_find(table.rows, [column](const auto& one, const auto& other) {
          return one.front() == other.front() && one[column] != other[column];
        }) == table.rows.end();
    if (!isShared) return column;
  }
  return kFirst;
}

/// A column that is not of words is of numbers.
Qt::Alignment alignmentOf(const Heading& heading) {
  return heading.isFreeText ? Qt::AlignLeft : Qt::AlignRight;
}

}  // namespace

ResultTable::ResultTable(QWidget* parent) : QTableWidget(parent) {
  makeReadOnly(*this);
  setWordWrap(true);
  setTextElideMode(Qt::ElideNone);
  setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
}

void ResultTable::show(const DataTable& table) {
  clear();
  clearSpans();
  setRowCount(0);
  setColumnCount(static_cast<int>(table.columns.size()));
  for (int column = 0; column < columnCount(); ++column) {
    const auto& heading = table.columns[static_cast<std::size_t>(column)];
    auto* item = new QTableWidgetItem(asText(heading.name));
    item->setTextAlignment(alignmentOf(heading) | Qt::AlignVCenter);
    setHorizontalHeaderItem(column, item);
  }
  setAccessibleName(asText(table.description));
  fill(table);
  fitColumns();
}

void ResultTable::fill(const DataTable& table) {
  const bool hasGroups = isGrouped(table);
  const auto own = hasGroups ? firstOwnColumn(table) : 0;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    const bool isSaidAbove = column != 1 && column < own;
    const bool isEmpty = std::ranges::all_of(
        table.rows, [column](const auto& row) { return textOf(row[column]).isEmpty(); });
    setColumnHidden(static_cast<int>(column), isSaidAbove || isEmpty);
  }
  QString group;
  for (const auto& row : table.rows) {
    std::vector<QString> cells;
    for (const auto& cell : row) cells.push_back(textOf(cell));
    if (hasGroups && (rowCount() == 0 || cells.front() != group)) {
      QStringList heading{cells.front()};
      for (std::size_t column = 2; column < own; ++column) {
        if (cells[column].isEmpty()) continue;
        heading << asText(table.columns[column].name) + QStringLiteral(": ") + cells[column];
      }
      addHeading(heading.join(QStringLiteral("  ·  ")));
    }
    group = cells.front();
    addRow(cells, table);
  }
}

void ResultTable::addHeading(const QString& words) {
  const int row = rowCount();
  insertRow(row);
  auto* cell = new QTableWidgetItem(words);
  auto font = cell->font();
  font.setBold(true);
  cell->setFont(font);
  cell->setFlags(Qt::ItemIsEnabled);
  cell->setTextAlignment(Qt::AlignBottom | Qt::AlignLeft);
  setItem(row, 1, cell);
  setSpan(row, 1, 1, columnCount() - 1);
}

void ResultTable::addRow(const std::vector<QString>& cells, const DataTable& table) {
  const int row = rowCount();
  insertRow(row);
  for (int column = 0; column < columnCount(); ++column) {
    const auto place = static_cast<std::size_t>(column);
    auto* cell = new QTableWidgetItem(cells[place]);
    cell->setTextAlignment(Qt::AlignTop | alignmentOf(table.columns[place]));
    setItem(row, column, cell);
  }
}

void ResultTable::fitColumns() {
  constexpr int kCellPadding = 16;  // [px] of a cell
  constexpr int kWidest = 190;
  int left = viewport()->width();
  std::vector<int> wideColumns;
  std::vector<int> columns;
  for (int column = 0; column < columnCount(); ++column) {
    if (isColumnHidden(column)) continue;
    columns.push_back(column);
    const int cells = sizeHintForColumn(column) + kCellPadding;
    if (cells > kWidest) wideColumns.push_back(column);
    const int heading = horizontalHeader()->sectionSizeHint(column);
    setColumnWidth(column, std::max(heading, std::min(kWidest, cells)));
    left -= columnWidth(column);
  }
  const auto& sharing = wideColumns.empty() ? columns : wideColumns;
  int others = static_cast<int>(sharing.size());
  for (const int column : sharing) {
    const int more = std::max(0, left / others--);
    setColumnWidth(column, columnWidth(column) + more);
    left -= more;
  }
  resizeRowsToContents();
  emit columnsFitted();
}

int ResultTable::wholeHeight() const {
  const bool isWide = horizontalHeader()->length() > viewport()->width();
  return horizontalHeader()->sizeHint().height() + verticalHeader()->length() + 2 * frameWidth() +
         (isWide ? horizontalScrollBar()->sizeHint().height() : 0);
}

QStringList ResultTable::lines(bool isAll) const {
  QStringList lines;
  for (int row = 0; row < rowCount(); ++row) {
    if (item(row, 0) == nullptr) continue;  // the heading of a group
    QStringList texts;
    for (int column = 0; column < columnCount(); ++column) {
      const auto* cell = item(row, column);
      if (isAll || cell->isSelected()) texts << cell->text();
    }
    if (!texts.isEmpty()) lines << texts.join(u'\t');
  }
  return lines;
}

void ResultTable::resizeEvent(QResizeEvent* event) {
  QTableWidget::resizeEvent(event);
  if (event->size().width() != event->oldSize().width()) fitColumns();
}

void ResultTable::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy)) {
    emit copyRequested();  // Qt copies one cell
  } else {
    QTableWidget::keyPressEvent(event);
  }
}

}  // namespace study::gui
