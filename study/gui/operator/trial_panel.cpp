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
      numbers_(quietLabel({}, this)),
      boneColours_(new BoneColoursButton(this)),
      plots_(new QHBoxLayout),
      plot_(new LivePlot(this)),
      travel_(new TravelPlot(this)),
      servo_(new ServoPanel(this)),
      cuts_(new CutTable(this)) {
  constexpr int kThreeCuts = 150;  // [px]
  constexpr int kFiveCuts = 210;
  cuts_->setMinimumHeight(kThreeCuts);
  cuts_->setMaximumHeight(kFiveCuts);
  // These take all free space and ignore their size hints, which are too large for a low
  // screen.
  const std::array<QWidget*, 3> flexibleWidgets{plot_, travel_, cuts_};
  for (auto* widget : flexibleWidgets) {
    widget->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
  }

  auto* layout = withoutMargins<QVBoxLayout>(this);
  auto* above = new QHBoxLayout;
  above->addWidget(numbers_, 1);
  above->addWidget(boneColours_);
  layout->addLayout(above);
  plots_->addWidget(plot_, 3);
  plots_->addWidget(travel_, 2);
  layout->addLayout(plots_, 7);
  layout->addWidget(servo_);
  layout->addWidget(cuts_, 1);
  setController(nullptr);
}

/// Puts the two plots beside each other, or in a narrow panel above one another.
void TrialPanel::resizeEvent(QResizeEvent* event) {
  constexpr int kLeastWidthOfTwoPlots = 700;  // [px]
  const bool isWide = width() >= kLeastWidthOfTwoPlots;
  plots_->setDirection(isWide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  QWidget::resizeEvent(event);
}

void TrialPanel::showForces(bool areShown) {
  areForcesShown_ = areShown;
  for (QWidget* each :
       {static_cast<QWidget*>(plot_),
        static_cast<QWidget*>(travel_),
        static_cast<QWidget*>(cuts_)}) {
    each->setVisible(areShown);
  }
  servo_->showForces(areShown);
  showNumbers();
}

void TrialPanel::takeSteps(TimelineTable& steps) {
  steps.scrollItself(true);
  constexpr int kAlone = 1000;  // nothing else takes free space while the forces are hidden
  static_cast<QBoxLayout*>(layout())->addWidget(&steps, kAlone);
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
  updateStep();
}

void TrialPanel::closeBoneWindow() {
  boneColours_->closeWindow();
}

void TrialPanel::updateStep() {
  const bool isRunning = controller_ != nullptr && controller_->isTrialRunning();
  if (isRunning && !wasRunning_) beginTrial();
  wasRunning_ = isRunning;
  if (!isRunning) clearBeforeNextTrial();
  boneColours_->refresh();
  showNumbers();
}

/// The force and the travel of now, or that they are hidden.
void TrialPanel::showNumbers() {
  const auto hidden =
      tr("Force curves are hidden: they tell conditions apart (View, Force curves).");
  const bool isRunning = controller_ != nullptr && controller_->isTrialRunning();
  if (!isRunning) return numbers_->setText(areForcesShown_ ? QString() : hidden);
  const auto status = controller_->trialStatus();
  const auto scale = travelScaleOf(controller_->deviceKind());
  const auto shown = tr("Force %1 N · travel %2 %3")
                         .arg(shownNumber(status.force))
                         .arg(shownNumber(scale.factor * status.travel))
                         .arg(scale.unit);
  numbers_->setText((areForcesShown_ ? shown : hidden) + viewInWords(*controller_));
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

void TrialPanel::updateTrial() {
  if (controller_ == nullptr || !controller_->isTrialRunning()) return;
  showNumbers();
  boneColours_->refresh();
  haptics::engine::TickSample sample;
  while (controller_->nextToPlot(sample)) {
    plot_->add(sample);
    travel_->add(sample);
    servo_->add(sample);
    cuts_->add(sample);
  }
  if (areForcesShown_) plot_->refresh();
  if (areForcesShown_) travel_->refresh();
  servo_->setPriority(controller_->trialStatus().isRealtime);
  servo_->refresh();
}

}  // namespace study::gui
