#include "study/gui/participant/trial_page.h"

#include <algorithm>
#include <cmath>

#include <QGridLayout>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QSignalBlocker>

#include "study/gui/participant/column.h"
#include "study/gui/participant/cut_counter.h"
#include "study/gui/participant/stage.h"
#include "study/gui/session/tool_picture.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {

constexpr double kWholeStroke = 220.0;  // [px]: dragging distance that closes the handle completely
constexpr int kClosingTime = 1200;      // [ms] of the space bar, from open to closed
constexpr int kOpeningTime = 400;

/// The number of a step, before its words, as in a numbered list.
QLabel* stepNumber(int number, QWidget* parent) {
  auto* label = bodyLabel(QStringLiteral("%1.").arg(number), parent);
  label->setProperty("role", QStringLiteral("statement"));
  label->setAlignment(Qt::AlignTop);
  return label;
}

}  // namespace

TrialPage::TrialPage(const Content& content, QWidget* picture, QWidget* parent)
    : QWidget(parent),
      content_(content),
      stage_(new Stage(
          content.title,
          picture != nullptr ? picture : toolCardOf(*content.device, InstrumentIs::Simulated, this),
          picture != nullptr ? Stage::Panel::Picture : Stage::Panel::Card,
          this)),
      cutCounter_(new CutCounter(
          content.minimumCuts,
          {asText(content.device->strokeName.in(content.language)),
           asText(content.device->strokesName.in(content.language))},
          this)),
      numberingHint_(bodyLabel(
          tr("The numbers start again: %1 may now stand for something else than before.")
              .arg(content.name),
          this)),
      takeHint_(bodyLabel({}, this)),
      strokeHint_(bodyLabel({}, this)),
      doneHint_(bodyLabel(tr("Press Done, and let go."), this)),
      stepNumbers_{stepNumber(1, this), stepNumber(2, this), stepNumber(3, this)},
      pointerHint_(quietLabel({}, this)),
      beginButton_(
          new QPushButton(content.isOptionalTrial ? tr("Feel it again") : tr("Begin"), this)),
      doneButton_(new QPushButton(tr("Done"), this)),
      declineButton_(new QPushButton(tr("No, go on"), this)) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(content.title);
  addColumn(*this, ColumnWidth::Page)->addWidget(stage_);
  stage_->setCaption(tr("The handle of the simulator"));
  addWords(picture != nullptr);
  stage_->setCounter(cutCounter_);
  for (auto* button : {declineButton_, beginButton_, doneButton_}) stage_->addButton(button);
  connect(beginButton_, &QPushButton::clicked, this, &TrialPage::beginRequested);
  connect(doneButton_, &QPushButton::clicked, this, &TrialPage::finishRequested);
  connect(declineButton_, &QPushButton::clicked, this, &TrialPage::declined);
  hand_.setParent(this);
  hand_.setStartValue(0.0);
  connect(&hand_, &QVariantAnimation::valueChanged, this, [this](const QVariant& share) {
    if (isRunning_) emit handMoved(share.toDouble());
  });
  setRunning(false);
}

/// Moves the hand from its present position to @p share. A whole stroke takes @p duration [ms].
void TrialPage::moveHandTo(double share, int duration) {
  const double from = hand_.state() == QAbstractAnimation::Running ? hand_.currentValue().toDouble()
                                                                   : hand_.endValue().toDouble();
  {
    const QSignalBlocker quiet(hand_);  // each of these calls would emit a value
    hand_.stop();
    hand_.setStartValue(from);
    hand_.setEndValue(share);
    hand_.setDuration(std::max(1, static_cast<int>(std::abs(share - from) * duration)));
  }
  hand_.start();
}

void TrialPage::addWords(bool hasPicture) {
  auto& words = stage_->words();
  if (content_.isByFeelAlone) {
    auto* byFeel =
        bodyLabel(tr("By feel alone: in this round you do not see what you work on."), this);
    byFeel->setProperty("role", QStringLiteral("key"));
    words.addWidget(byFeel);
  }
  numberingHint_->setProperty("role", QStringLiteral("text"));
  words.addWidget(numberingHint_);
  auto* steps = new QGridLayout;
  steps->setHorizontalSpacing(scaled(*this, 10));
  steps->setVerticalSpacing(scaled(*this, 10));
  steps->setColumnStretch(1, 1);
  int row = 0;
  for (auto* hint : {takeHint_, strokeHint_, doneHint_}) {
    hint->setProperty("role", QStringLiteral("statement"));
    hint->setAlignment(Qt::AlignTop);
    steps->addWidget(stepNumbers_[static_cast<std::size_t>(row)], row, 0);
    steps->addWidget(hint, row++, 1);
  }
  words.addLayout(steps);
  auto* cutOpen = quietLabel(tr("The bone is drawn cut open."), this);
  cutOpen->setVisible(hasPicture && content_.device->tissue == haptics::devices::Tissue::Bone);
  words.addWidget(cutOpen);
  pointerHint_->setObjectName(QStringLiteral("pointer-hint"));
  words.addWidget(pointerHint_);
}

/// How a stroke is made, and before the trial how often.
QString TrialPage::howTo() const {
  const auto how = asText(content_.device->strokeHint.in(content_.language));
  if (isRunning_ || content_.minimumCuts < 2) return how;  // the counter then says how often
  return how + QLatin1Char(' ') + tr("Do this at least %1 times.").arg(content_.minimumCuts);
}

void TrialPage::setRunning(bool isRunning, bool isVirtual) {
  isRunning_ = isRunning;
  beginButton_->setVisible(!isRunning);
  numberingHint_->setVisible(!isRunning && content_.reusesLabels);
  doneButton_->setVisible(isRunning);
  declineButton_->setVisible(!isRunning && content_.isOptionalTrial);
  const bool isOffer = !isRunning && content_.isOptionalTrial;
  cutCounter_->setVisible(!isOffer);
  takeHint_->setText(
      isRunning ? QString()
                : tr("Press Begin, then take the instrument: it resists from then on."));
  for (auto* hint : {takeHint_, doneHint_}) hint->setVisible(!isRunning && !isOffer);
  for (auto* number : stepNumbers_) number->setVisible(!isRunning && !isOffer);
  strokeHint_->setText(
      isOffer ? tr("Would you like to feel it once more before you choose?") : howTo());
  pointerHint_->setText(asText(content_.device->pointerHint.in(content_.language)));
  pointerHint_->setVisible(isRunning && isVirtual);
  setCuts(0);
  isRunning ? setFocus() : beginButton_->setFocus();
}

void TrialPage::setCuts(int cuts) {
  cutCounter_->setCount(cuts);
  const int left = content_.minimumCuts - cuts;
  const bool isEnough = isRunning_ && left <= 0;
  if (isEnough && !doneButton_->isEnabled()) {
    strokeHint_->setText(tr("That is enough. Press Done, or feel it for longer."));
  }
  doneButton_->setEnabled(isEnough);
  const auto& strokes = left == 1 ? content_.device->strokeName : content_.device->strokesName;
  stage_->setReason(
      isRunning_ && left > 0 ? tr("%1 %2 left").arg(left).arg(asText(strokes.in(content_.language)))
                             : QString());
}

void TrialPage::mousePressEvent(QMouseEvent* event) {
  pressedAt_ = event->position().y();
  if (isRunning_) setFocus();
}

void TrialPage::mouseMoveEvent(QMouseEvent* event) {
  if (!isRunning_ || (event->buttons() & Qt::LeftButton) == 0) return;
  emit handMoved(std::clamp((event->position().y() - pressedAt_) / kWholeStroke, 0.0, 1.0));
}

void TrialPage::mouseReleaseEvent(QMouseEvent* /*event*/) {
  if (isRunning_) emit handMoved(0.0);
}

void TrialPage::keyPressEvent(QKeyEvent* event) {
  if (isRunning_ && event->key() == Qt::Key_Space) {
    if (!event->isAutoRepeat()) moveHandTo(1.0, kClosingTime);
    return;
  }
  const bool isReamer = content_.device->tissue == haptics::devices::Tissue::Bone;
  if (isRunning_ && isReamer && event->key() == Qt::Key_R) {
    if (!event->isAutoRepeat()) emit reamerSwitched();
    return;
  }
  QWidget::keyPressEvent(event);
}

void TrialPage::keyReleaseEvent(QKeyEvent* event) {
  if (isRunning_ && event->key() == Qt::Key_Space) {
    if (!event->isAutoRepeat()) moveHandTo(0.0, kOpeningTime);
    return;
  }
  QWidget::keyReleaseEvent(event);
}

}  // namespace study::gui
