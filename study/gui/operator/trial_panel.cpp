#include "study/gui/operator/trial_panel.h"

#include <array>
#include <cmath>

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "haptics/registry/device_kinds.h"
#include "study/gui/operator/bone_colours_button.h"
#include "study/gui/operator/cut_table.h"
#include "study/gui/operator/live_plot.h"
#include "study/gui/operator/servo_panel.h"
#include "study/gui/operator/timeline_table.h"
#include "study/gui/operator/travel_plot.h"
#include "study/gui/operator/travel_scale.h"
#include "study/gui/session/trial_view.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"

namespace study::gui {
namespace {

constexpr double kNominalRate = 1000.0;  // [Hz]

/// Two decimals, with a minus sign, and without one before zero.
QString shownNumber(double value) {
  constexpr double kShown = 0.005;
  const auto digits = QString::number(std::abs(value), 'f', 2);
  return value > -kShown ? digits : QStringLiteral("−") + digits;
}

}  // namespace

TrialPanel::TrialPanel(QWidget* parent)
    : QWidget(parent),
      steps_(new TimelineTable(this)),
      health_(new QLabel(this)),
      cutCount_(headingLabel({}, this)),
      numbers_(quietLabel({}, this)),
      boneColours_(new BoneColoursButton(this)),
      plot_(new LivePlot(this)),
      travel_(new TravelPlot(this)),
      servo_(new ServoPanel(this)),
      cuts_(new CutTable(this)) {
  cutCount_->setWordWrap(false);
  health_->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  health_->setMinimumHeight(36);
  constexpr int kThreeCuts = 122;  // [px]
  constexpr int kFiveCuts = 180;
  cuts_->setMinimumHeight(kThreeCuts);
  cuts_->setMaximumHeight(kFiveCuts);
  constexpr int kFiveSteps = 190;  // [px]
  steps_->setMinimumHeight(kFiveSteps);
  // These take all free space and ignore their size hints, which are too large for a low
  // screen.
  const std::array<QWidget*, 4> flexibleWidgets{steps_, plot_, travel_, cuts_};
  for (auto* widget : flexibleWidgets) {
    widget->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
  }

  auto* layout = withoutMargins<QVBoxLayout>(this);
  layout->addWidget(steps_, 2);
  auto* numbers = new QHBoxLayout;
  numbers->addWidget(health_, 1);
  numbers->addWidget(cutCount_);
  layout->addLayout(numbers);
  auto* below = new QHBoxLayout;
  below->addWidget(numbers_, 1);
  below->addWidget(boneColours_);
  layout->addLayout(below);
  auto* plots = new QHBoxLayout;
  plots->addWidget(plot_, 3);
  plots->addWidget(travel_, 3);
  layout->addLayout(plots, 7);
  layout->addWidget(servo_);
  layout->addWidget(cuts_, 1);
  setController(nullptr);
}

void TrialPanel::setController(SessionController* controller) {
  controller_ = controller;
  wasRunning_ = false;
  // Clears the previous session's trial. Uses the first device that the protocol declares, which
  // does not reveal the device of the first trial.
  const auto* devices =
      controller == nullptr ? nullptr : &controller->session().protocol().protocol.devices;
  const bool isFelt = devices != nullptr && !devices->empty();
  clearTrial(isFelt ? *devices->front().kind : *haptics::deviceKinds().front(), kNominalRate);
  boneColours_->setController(controller);
  updateSteps();
}

void TrialPanel::closeBoneWindow() {
  boneColours_->closeWindow();
}

void TrialPanel::showHealth(const QString& words, Health health) {
  const char* const roles[] = {"good", "resting", "bad"};
  health_->setText(words);
  setRole(*health_, roles[static_cast<int>(health)]);
}

void TrialPanel::updateSteps() {
  cutCount_->hide();
  numbers_->clear();
  steps_->show(controller_);
  const bool isRunning = controller_ != nullptr && controller_->isTrialRunning();
  if (isRunning && !wasRunning_) beginTrial();
  wasRunning_ = isRunning;
  if (!isRunning) clearBeforeNextTrial();
  boneColours_->refresh();
  showState();
}

void TrialPanel::clearTrial(const haptics::devices::DeviceKind& device, double rate) {
  plot_->begin(device, rate);
  travel_->begin(device);
  servo_->begin(device, rate);
  cuts_->begin(device, rate);
}

void TrialPanel::beginTrial() {
  clearTrial(controller_->deviceKind(), controller_->trialRate());
}

void TrialPanel::clearBeforeNextTrial() {
  if (controller_ == nullptr) return;
  const auto& session = controller_->session();
  const bool isNext = !session.isOver() && session.state() != SessionState::Interrupted &&
                      session.step().kind == StepKind::Trial;
  if (isNext) clearTrial(controller_->deviceKind(), kNominalRate);
}

void TrialPanel::showState() {
  if (controller_ == nullptr) {
    showHealth(tr("no session"), Health::NoForce);
    return;
  }
  const QString device = controller_->deviceName();
  const auto& session = controller_->session();
  if (session.isOver()) {
    showHealth(tr("this session is over: %1").arg(statusInWords(session.state())), Health::NoForce);
  } else if (session.state() == SessionState::Paused) {
    showHealth(tr("‖ paused: no force"), Health::NoForce);
  } else if (session.state() == SessionState::Interrupted) {
    showHealth(tr("✖ trial broke off: no force"), Health::Bad);
  } else if (wasRunning_) {
    const bool isReamer = controller_->deviceKind().tissue == haptics::devices::Tissue::Bone;
    showHealth(
        isReamer ? tr("● %1: running · R: reamer off and on").arg(device)
                 : tr("● %1: running").arg(device),
        Health::Good);
  } else {
    showHealth(
        device.isEmpty() ? tr("no device needed now") : tr("%1: no force yet").arg(device),
        Health::NoForce);
  }
}

void TrialPanel::updateTrial() {
  if (controller_ == nullptr || !controller_->isTrialRunning()) return;
  const auto status = controller_->trialStatus();
  const auto& kind = controller_->deviceKind();
  const auto scale = travelScaleOf(kind);
  const int asked = controller_->session().step().minimumCuts;
  cutCount_->show();
  const auto counted = status.cuts > asked ? tr("%1 %3 (at least %2)") : tr("%1 of %2 %3");
  cutCount_->setText(
      counted.arg(status.cuts).arg(asked).arg(asText(kind.strokesName.in(deskLanguage()))));
  numbers_->setText(
      tr("Force %1 N · travel %2 %3")
          .arg(shownNumber(status.force))
          .arg(shownNumber(scale.factor * status.travel))
          .arg(scale.unit) +
      viewInWords(*controller_));
  boneColours_->refresh();
  haptics::engine::TickSample sample;
  while (controller_->nextToPlot(sample)) {
    plot_->add(sample);
    travel_->add(sample);
    servo_->add(sample);
    cuts_->add(sample);
  }
  plot_->refresh();
  travel_->refresh();
  servo_->setPriority(status.isRealtime);
  servo_->refresh();
}

}  // namespace study::gui
