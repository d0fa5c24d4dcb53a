#include "study/gui/trial_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "study/gui/labels.h"

namespace study::gui {
namespace {

/// A step as an operator may read it: the alternative, never what it is.
QString describe(const Step& step) {
  const QString phase = QString::fromStdString(step.phase);
  if (step.kind == StepKind::Trial) {
    return TrialPanel::tr("%1: Alternative %2").arg(phase).arg(step.label);
  }
  if (step.kind == StepKind::Questionnaire) {
    return TrialPanel::tr("%1: questions on Alternative %2").arg(phase).arg(step.label);
  }
  return phase;
}

QString kindOf(const Step& step) {
  const auto name = nameOf(step.kind);
  return QString::fromUtf8(name.data(), static_cast<int>(name.size()));
}

}  // namespace

TrialPanel::TrialPanel(QWidget* parent)
    : QWidget(parent),
      steps_(new QTableWidget(this)),
      health_(new QLabel(this)),
      cuts_(titleLabel({}, this)),
      clock_(quietLabel({}, this)),
      plot_(new LivePlot(this)) {
  steps_->setColumnCount(3);
  steps_->setHorizontalHeaderLabels({tr("Step"), tr("Kind"), tr("State")});
  steps_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  steps_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  steps_->setColumnWidth(2, 80);
  steps_->verticalHeader()->hide();
  steps_->setSelectionMode(QAbstractItemView::NoSelection);
  steps_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  steps_->setFocusPolicy(Qt::NoFocus);
  health_->setAlignment(Qt::AlignCenter);
  health_->setMinimumHeight(36);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(steps_, 3);
  auto* numbers = new QHBoxLayout;
  numbers->addWidget(health_, 1);
  numbers->addWidget(cuts_);
  layout->addLayout(numbers);
  layout->addWidget(clock_);
  layout->addWidget(plot_, 2);
  follow(nullptr);
}

void TrialPanel::follow(SessionController* controller) {
  controller_ = controller;
  plot_->clear();
  updateSteps();
}

void TrialPanel::showHealth(const QString& words, bool isHealthy) {
  health_->setText(words);
  health_->setStyleSheet(
      isHealthy
          ? QStringLiteral("background:#1e6b3a;color:#ffffff;border-radius:6px;font-weight:600;")
          : QStringLiteral("background:#b3261e;color:#ffffff;border-radius:6px;font-weight:600;"));
}

void TrialPanel::updateSteps() {
  cuts_->clear();
  clock_->clear();
  if (controller_ == nullptr) {
    steps_->setRowCount(0);
    showHealth(tr("no session"), false);
    return;
  }
  const auto& session = controller_->session();
  steps_->setRowCount(static_cast<int>(session.plan().size()));
  for (int row = 0; row < steps_->rowCount(); ++row) {
    const auto& step = session.plan()[static_cast<std::size_t>(row)];
    const QString state = row < session.stepIndex()   ? tr("done")
                          : row > session.stepIndex() ? QString()
                                                      : tr("now");
    const std::array<QString, 3> cells{describe(step), kindOf(step), state};
    for (int column = 0; column < 3; ++column) {
      auto* cell = new QTableWidgetItem(cells[static_cast<std::size_t>(column)]);
      if (row == session.stepIndex()) cell->setBackground(QColor(0xff, 0xf1, 0xd6));
      steps_->setItem(row, column, cell);
    }
  }
  if (session.stepIndex() < steps_->rowCount()) {
    steps_->scrollToItem(steps_->item(session.stepIndex(), 0), QAbstractItemView::PositionAtCenter);
  }
  const bool isRunning = controller_->isTrialRunning();
  if (isRunning && !wasRunning_) plot_->clear();
  wasRunning_ = isRunning;
  const bool isBroken = session.state() == SessionState::Interrupted;
  const QString device = controller_->deviceName();
  showHealth(
      isBroken ? tr("trial broke off: no force")
      : isRunning
          ? tr("%1: running").arg(device)
          : (device.isEmpty() ? tr("no device needed now") : tr("%1: not armed").arg(device)),
      !isBroken && (isRunning || device.isEmpty()));
}

void TrialPanel::updateTrial() {
  if (controller_ == nullptr || !controller_->isTrialRunning()) return;
  const auto status = controller_->trialStatus();
  cuts_->setText(tr("%1 of %2").arg(status.cuts).arg(controller_->session().step().minimumCuts));
  clock_->setText(tr("%1 N at %2 · %3 ticks, %4 late · %5")
                      .arg(status.force, 0, 'f', 2)
                      .arg(status.travel, 0, 'f', 3)
                      .arg(status.ticks)
                      .arg(status.lateTicks)
                      .arg(status.isRealtime ? tr("real-time priority") : tr("ordinary priority")));
  haptics::engine::TickSample sample;
  constexpr double kTick = 0.001;  // [s]
  while (controller_->nextToPlot(sample)) {
    plot_->add(static_cast<double>(sample.tick) * kTick, sample.force, sample.travel);
  }
  plot_->refresh();
}

}  // namespace study::gui
