#include "study/gui/authoring/timeline_page.h"

#include <cmath>
#include <map>
#include <utility>

#include <QHeaderView>
#include <QVBoxLayout>

#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"
#include "study/session/session_length.h"

namespace study::gui {
namespace {

QString asMinutes(double seconds) {
  return QString::number(seconds / 60.0, 'f', 1);
}

/// Describes a step without its condition, which depends on the participant's order.
QString describeStep(const Step& step, const PartOfSession& part) {
  QString words = deskText(nameOf(step.kind));
  if (step.label > 0) words += TimelinePage::tr(", position %1").arg(step.position);
  if (part.items == 1) words += TimelinePage::tr(", 1 item");
  if (part.items > 1) words += TimelinePage::tr(", %1 items").arg(part.items);
  if (part.cuts > 0) words += TimelinePage::tr(", at least %1 strokes").arg(part.cuts);
  return words;
}

std::vector<Step> stepsOf(const protocols::Protocol& protocol) {
  const auto schedule =
      protocols::scheduleFor(protocol, protocol.seed.value_or(1), protocol.cohorts.front().id, 0);
  return sessionPlan(protocol, schedule);
}

}  // namespace

TimelinePage::TimelinePage(QWidget* parent)
    : QWidget(parent),
      bar_(new TimelineBar(this)),
      total_(bodyLabel({}, this)),
      steps_(new QTreeWidget(this)) {
  steps_->setHeaderLabels({tr("Phase"), tr("What happens"), tr("Minutes")});
  steps_->header()->setStretchLastSection(false);
  steps_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  steps_->header()->setSectionResizeMode(1, QHeaderView::Stretch);
  steps_->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
  steps_->setAccessibleName(tr("Phases and steps"));
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(total_);
  layout->addWidget(bar_);
  layout->addWidget(quietLabel(
      tr("Filled: touching the device. The rest is for reading, answers, the real tool and breaks. "
         "Estimated with eight seconds for each item and each stroke."),
      this));
  layout->addWidget(steps_, 1);
  connect(steps_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (item == nullptr) return;
    const auto* phase = item->parent() == nullptr ? item : item->parent();
    emit phaseChosen(phase->data(0, Qt::UserRole).toInt());
  });
}

void TimelinePage::clear() {
  steps_->clear();
  bar_->show(std::vector<TimelineBar::Part>());
  total_->setText(tr("The timeline appears here once the protocol has no errors."));
}

void TimelinePage::show(const protocols::LoadedProtocol& loaded) {
  const auto& protocol = loaded.protocol;
  const auto length = lengthOf(loaded, {});
  total_->setText(
      tr("A session takes about %1 minutes, of which about %2 are spent touching the device.")
          .arg(std::ceil(length.seconds / 60.0))
          .arg(std::ceil(length.secondsOnDevice / 60.0)));
  steps_->clear();
  std::vector<TimelineBar::Part> parts;
  const auto steps = stepsOf(protocol);
  for (std::size_t p = 0; p < protocol.phases.size(); ++p) {
    const auto& phase = protocol.phases[p];
    TimelineBar::Part whole{.name = phaseTitle(phase.id)};
    auto* top = new QTreeWidgetItem(steps_, {QStringLiteral("%1 %2").arg(p + 1).arg(whole.name)});
    top->setData(0, Qt::UserRole, static_cast<int>(p));
    int count = 0;
    for (const auto& step : steps) {
      if (step.phase != phase.id) continue;
      const auto part = partOf(loaded, step);
      const auto words = describeStep(step, part);
      new QTreeWidgetItem(top, {QString::number(++count), words, asMinutes(part.seconds)});
      if (step.isOptionalTrial) continue;  // few participants accept the offer
      whole.periods.push_back({.seconds = part.seconds - part.secondsOnDevice});
      whole.periods.push_back({.seconds = part.secondsOnDevice, .isOnDevice = true});
    }
    top->setText(1, count == 1 ? top->child(0)->text(1) : tr("%1 steps").arg(count));
    top->setText(2, asMinutes(whole.seconds()));
    parts.push_back(std::move(whole));
  }
  for (int i = 0; i < steps_->topLevelItemCount(); ++i) {
    auto* item = steps_->topLevelItem(i);
    if (item->childCount() == 1) delete item->takeChild(0);
  }
  bar_->show(std::move(parts));
}

}  // namespace study::gui
