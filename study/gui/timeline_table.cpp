#include "study/gui/timeline_table.h"

#include <array>

#include <QHeaderView>

namespace study::gui {
namespace {

QString words(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
}

/// A step as an operator may read it: the alternative, never what it is.
QString describe(const Step& step) {
  const QString phase = QString::fromStdString(step.phase);
  if (step.isOffered)
    return TimelineTable::tr("%1: Alternative %2 again?").arg(phase).arg(step.label);
  if (step.kind == StepKind::Trial) {
    return TimelineTable::tr("%1: Alternative %2").arg(phase).arg(step.label);
  }
  if (step.kind == StepKind::Questionnaire) {
    return TimelineTable::tr("%1: questions on Alternative %2").arg(phase).arg(step.label);
  }
  return phase;
}

/// How a step stands that is not the present one.
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

}  // namespace

TimelineTable::TimelineTable(QWidget* parent) : QTableWidget(0, 5, parent) {
  setObjectName(QStringLiteral("timeline"));
  setAccessibleName(tr("Steps of the session"));
  setHorizontalHeaderLabels({tr("#"), tr("Step"), tr("Kind"), tr("Attempts"), tr("State")});
  for (const int narrow : {0, 2, 3, 4}) {
    horizontalHeader()->setSectionResizeMode(narrow, QHeaderView::ResizeToContents);
  }
  horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  verticalHeader()->hide();
  setSelectionMode(QAbstractItemView::NoSelection);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setFocusPolicy(Qt::NoFocus);
}

void TimelineTable::show(const SessionController* controller) {
  if (controller == nullptr) {
    setRowCount(0);
    return;
  }
  const auto& session = controller->session();
  setRowCount(static_cast<int>(session.plan().size()));
  for (int row = 0; row < rowCount(); ++row) fillRow(row, *controller);
  if (session.stepIndex() < rowCount()) {
    scrollToItem(item(session.stepIndex(), 1), QAbstractItemView::PositionAtCenter);
  }
}

void TimelineTable::fillRow(int row, const SessionController& controller) {
  const auto& session = controller.session();
  const auto& step = session.plan()[static_cast<std::size_t>(row)];
  const bool isNow = !session.isOver() && row == session.stepIndex();
  const int attempts = controller.attempts(row);
  const std::array<QString, 5> cells{
      QString::number(row + 1),
      describe(step),
      words(nameOf(step.kind)),
      attempts > 0 ? QString::number(attempts) : QString(),
      isNow ? tr("▶ now") : stateOf(controller, row)};
  for (int column = 0; column < columnCount(); ++column) {
    auto* cell = new QTableWidgetItem(cells[static_cast<std::size_t>(column)]);
    if (isNow) {
      auto font = cell->font();
      font.setBold(true);
      cell->setFont(font);
    }
    setItem(row, column, cell);
  }
}

}  // namespace study::gui
