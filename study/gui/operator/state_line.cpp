#include "study/gui/operator/state_line.h"

#include <QVBoxLayout>

#include "haptics/registry/device_kinds.h"
#include "study/gui/session/session_controller.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"

namespace study::gui {

StateLine::StateLine(QWidget* parent)
    : QWidget(parent),
      health_(new QLabel(this)),
      disk_(bodyLabel(
          tr("▲ The disk is almost full: free space, or the next trial may break off."), this)),
      count_(headingLabel({}, this)) {
  health_->setObjectName(QStringLiteral("state"));
  health_->setWordWrap(true);
  disk_->setObjectName(QStringLiteral("disk"));
  setRole(*disk_, "warn");
  count_->setObjectName(QStringLiteral("count"));
  auto* layout = withoutMargins<QVBoxLayout>(this, 6);
  layout->addWidget(health_);
  layout->addWidget(disk_);
  layout->addWidget(count_);
  showState(nullptr);
}

void StateLine::show(const QString& words, Health health) {
  const char* const roles[] = {"good", "resting", "bad"};
  health_->setText(words);
  setRole(*health_, roles[static_cast<int>(health)]);
}

void StateLine::showState(const SessionController* controller) {
  const bool isRunning = controller != nullptr && controller->isTrialRunning();
  count_->hide();
  // Not during a trial: what is tried here takes room from its samples.
  if (!isRunning) disk_->setVisible(controller != nullptr && controller->isDiskAlmostFull());
  if (controller == nullptr) return show(tr("no session"), Health::NoForce);
  const auto& session = controller->session();
  if (session.isOver()) {
    const auto how = statusInWords(session.state());
    return show(tr("this session is over: %1").arg(how), Health::NoForce);
  }
  if (session.state() == SessionState::Paused) {
    return show(tr("‖ paused: no force"), Health::NoForce);
  }
  if (session.state() == SessionState::Interrupted) {
    return show(tr("✖ trial broke off: no force"), Health::Bad);
  }
  if (controller->isTrialUnsaved()) {
    return show(tr("✖ trial not saved: no force"), Health::Bad);
  }
  const QString device = controller->deviceName();
  const auto& step = session.step();
  if (step.kind == StepKind::Benchmark) {
    const auto& devices = session.protocol().protocol.devices;
    const auto* kind = devices.empty() ? haptics::deviceKinds().front() : devices.front().kind;
    showCount(session.benchmarkCuts(), step.minimumCuts, *kind);
  }
  if (!isRunning) {
    const auto waits = tr("%1: no force yet").arg(device);
    return show(device.isEmpty() ? tr("no device needed now") : waits, Health::NoForce);
  }
  showCount(*controller);
  const bool isReamer = controller->deviceKind().tissue == haptics::devices::Tissue::Bone;
  const auto runs = isReamer ? tr("● %1: running · R: reamer off and on") : tr("● %1: running");
  show(runs.arg(device), Health::Good);
}

void StateLine::showCount(const SessionController& controller) {
  showCount(
      controller.trialStatus().cuts,
      controller.session().step().minimumCuts,
      controller.deviceKind());
}

void StateLine::showCount(int made, int asked, const haptics::devices::DeviceKind& device) {
  const auto counted = made > asked ? tr("%1 %3 (at least %2)") : tr("%1 of %2 %3");
  count_->setText(counted.arg(made).arg(asked).arg(asText(device.strokesName.in(deskLanguage()))));
  count_->show();
}

}  // namespace study::gui
