#include "study/gui/widgets/findings_table.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include <QHeaderView>

#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/read_only_table.h"

namespace study::gui {
namespace {

using haptics::devices::Finding;

QString describe(const FindingLine& line) {
  if (!line.isTested) return FindingsTable::tr("– not tested");
  return line.found.finding == Finding::Pass   ? FindingsTable::tr("✓ good")
         : line.found.finding == Finding::Warn ? FindingsTable::tr("! could be better")
                                               : FindingsTable::tr("✕ fix it");
}

/// Lines are shown by their rank: the worst finding has the lowest, a line that was not tested the
/// highest of its finding.
using Rank = std::pair<int, bool>;
Rank rankOf(const FindingLine& line) {
  return {-static_cast<int>(line.found.finding), !line.isTested};
}

}  // namespace

FindingsTable::FindingsTable(QWidget* parent) : QTableWidget(0, 4, parent) {
  setAccessibleName(tr("What was found"));
  setHorizontalHeaderLabels({tr("Part"), tr("Result"), tr("What"), tr("Finding, and what to do")});
  makeReadOnly(*this);
  setSelectionMode(QAbstractItemView::NoSelection);
  setWordWrap(true);
  setTextElideMode(Qt::ElideNone);
  verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  auto* heads = horizontalHeader();
  heads->setSectionResizeMode(QHeaderView::ResizeToContents);
  heads->setSectionResizeMode(3, QHeaderView::Stretch);
  // A scroll bar that appears leaves the columns less room, and the rows then need more.
  connect(heads, &QHeaderView::sectionResized, this, &QTableWidget::resizeRowsToContents);
  // Queued: a header that resizes its rows knows their sum only afterwards.
  connect(
      verticalHeader(),
      &QHeaderView::sectionResized,
      this,
      &FindingsTable::fitRows,
      Qt::QueuedConnection);
}

/// No higher than its rows.
void FindingsTable::fitRows() {
  setMaximumHeight(
      horizontalHeader()->sizeHint().height() + verticalHeader()->length() + 2 * frameWidth());
}

void FindingsTable::show(std::vector<FindingLine> lines, bool hasDetails) {
  std::map<std::string, Rank> rankOfPart;  // that of its worst line
  for (const auto& line : lines) {
    auto& rank = rankOfPart.try_emplace(line.part, rankOf(line)).first->second;
    rank = std::min(rank, rankOf(line));
  }
  std::ranges::stable_sort(lines, {}, [&](const FindingLine& line) {
    return std::tuple(rankOfPart.at(line.part), line.part, rankOf(line));
  });
  clearSpans();
  setRowCount(static_cast<int>(lines.size()));
  int first = 0;  // row of the part
  for (int row = 0; row < rowCount(); ++row) {
    const auto& line = lines[static_cast<std::size_t>(row)];
    const auto& found = line.found;
    QStringList finding{capitalised(deskText(found.measured))};
    if (hasDetails && !line.details.empty()) finding << asText(line.details);
    if (!found.fix.empty()) finding << QStringLiteral("→ ") + deskText(found.fix);
    const QString cells[]{
        capitalised(deskText(line.part)),
        describe(line),
        capitalised(deskText(found.what)),
        finding.join(QLatin1Char('\n'))};
    for (int column = 0; column < columnCount(); ++column) {
      auto* cell = new QTableWidgetItem(cells[column]);
      cell->setTextAlignment(Qt::AlignTop | Qt::AlignLeft);
      if (column == 1 && found.finding != Finding::Pass) {
        auto font = cell->font();
        font.setBold(true);
        cell->setFont(font);
      }
      setItem(row, column, cell);
    }
    if (lines[static_cast<std::size_t>(first)].part != line.part) first = row;
    if (row > first) setSpan(first, 0, row - first + 1, 1);
  }
}

}  // namespace study::gui
