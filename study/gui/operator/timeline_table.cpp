#include "study/gui/operator/timeline_table.h"

#include <algorithm>
#include <array>

#include <QHeaderView>
#include <QResizeEvent>

#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/read_only_table.h"

namespace study::gui {
namespace {

/// The status of a step other than the current one.
QString stateOf(const SessionController& controller, int step) {
  if (controller.attempts(step) == 0) return {};
  switch (controller.statusOf(step)) {
    case storage::VisitStatus::Finished:
      return TimelineTable::tr("done");
    case storage::VisitStatus::Skipped:
      return TimelineTable::tr("skipped");
    case storage::VisitStatus::Repeated:
      return TimelineTable::tr("to be repeated");
    case storage::VisitStatus::BrokenOff:
      return TimelineTable::tr("broken off");
    case storage::VisitStatus::Open:
      return TimelineTable::tr("open");
  }
  return {};
}

/// The state of the current step, in the same words as in the status line of the trial.
QString stateNow(const SessionController& controller) {
  const auto state = controller.session().state();
  if (state == SessionState::Interrupted) return TimelineTable::tr("✖ broke off");
  if (state == SessionState::Paused) return TimelineTable::tr("‖ paused");
  return controller.isTrialRunning() ? TimelineTable::tr("● running") : TimelineTable::tr("▶ now");
}

}  // namespace

TimelineTable::TimelineTable(QWidget* parent) : QTableWidget(0, 5, parent) {
  setAccessibleName(tr("Steps of the session"));
  setHorizontalHeaderLabels({tr("#"), tr("Step"), tr("Kind"), tr("Attempts"), tr("Status")});
  horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSelectionMode(QAbstractItemView::NoSelection);
  makeReadOnly(*this);
  setFocusPolicy(Qt::NoFocus);
  fitHeight();
  // A narrow column wraps the names of steps. Queued: a header that resizes its sections knows
  // their sizes only afterwards.
  connect(
      horizontalHeader(),
      &QHeaderView::sectionResized,
      this,
      &QTableWidget::resizeRowsToContents,
      Qt::QueuedConnection);
  connect(
      verticalHeader(),
      &QHeaderView::sectionResized,
      this,
      &TimelineTable::fitHeight,
      Qt::QueuedConnection);
  // The hint is too large for a low screen.
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
}

void TimelineTable::resizeEvent(QResizeEvent* event) {
  constexpr int kRoomForTheKind = 640;  // [px]; the step's name contains its kind as well
  constexpr int kRoomForTheAttempts = 480;
  setColumnHidden(2, event->size().width() < kRoomForTheKind);
  setColumnHidden(3, event->size().width() < kRoomForTheAttempts);
  // The step's name needs more room than its status, which wraps.
  setColumnWidth(4, std::min(widthOfStatus(), event->size().width() * 35 / 100));
  QTableWidget::resizeEvent(event);
}

void TimelineTable::scrollItself(bool does) {
  scrollsItself_ = does;
  fitHeight();
}

void TimelineTable::fitHeight() {
  const int all = horizontalHeader()->sizeHint().height() + verticalHeader()->length();
  setMinimumHeight(scrollsItself_ ? kLeastHeight : std::max(kLeastHeight, all + 2 * frameWidth()));
}

/// The width of the longest status, as bold as that of the current step.
int TimelineTable::widthOfStatus() const {
  auto bold = font();
  bold.setBold(true);
  int widest = 0;  // "to be repeated" is wrapped
  for (const auto& words : {tr("broken off"), tr("✖ broke off"), tr("‖ paused"), tr("● running")}) {
    widest = std::max(widest, QFontMetrics(bold).horizontalAdvance(words));
  }
  constexpr int kCellPadding = 16;  // [px]
  return widest + kCellPadding;
}

void TimelineTable::show(const SessionController* controller) {
  const int steps =
      controller == nullptr ? 0 : static_cast<int>(controller->session().plan().size());
  const bool isNew = rowCount() != steps;
  setRowCount(steps);
  if (controller == nullptr) return;
  for (int row = 0; row < steps; ++row) fillRow(row, *controller);
  // Measured only once: at each step it would take longer than saving the answers.
  for (const int narrow : {0, 2, 3}) {
    if (isNew) resizeColumnToContents(narrow);
  }
  constexpr int kBolder = 8;  // [px] of the current step's number
  if (isNew) setColumnWidth(0, columnWidth(0) + kBolder);
  if (isNew) resizeRowsToContents();
  if (isNew) fitHeight();
  const int now = controller->session().stepIndex();
  if (now < steps) scrollToItem(item(now, 1), QAbstractItemView::PositionAtCenter);
}

void TimelineTable::write(int row, int column, const QString& words, bool isNow) {
  auto* cell = item(row, column);
  if (cell == nullptr) {
    cell = new QTableWidgetItem;
    setItem(row, column, cell);
  }
  if (cell->text() != words) cell->setText(words);
  auto font = cell->font();
  if (font.bold() == isNow) return;
  font.setBold(isNow);
  cell->setFont(font);
}

void TimelineTable::fillRow(int row, const SessionController& controller) {
  const auto& session = controller.session();
  const auto& step = session.plan()[static_cast<std::size_t>(row)];
  const bool isNow = !session.isOver() && row == session.stepIndex();
  const int attempts = controller.attempts(row);
  const std::array<QString, 5> cells{
      QString::number(row + 1),
      describe(step, session.protocol().protocol.labels),
      deskText(nameOf(step.kind)),
      attempts > 0 ? QString::number(attempts) : QString(),
      isNow ? stateNow(controller) : stateOf(controller, row)};
  for (int column = 0; column < columnCount(); ++column) {
    write(row, column, cells[static_cast<std::size_t>(column)], isNow);
  }
}

}  // namespace study::gui
