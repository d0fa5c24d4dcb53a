#include "study/gui/participant/trial_page.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "study/gui/participant/cut_counter.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {
constexpr double kWholeStroke = 220.0;  // [px]: dragging distance that closes the handle completely
constexpr int kClosing = 1200;          // [ms] of the space bar, from open to closed
constexpr int kOpening = 400;
}  // namespace

TrialPage::TrialPage(const Content& content, QWidget* picture, QWidget* parent)
    : QWidget(parent),
      content_(content),
      count_(nullptr),
      numbering_(bodyLabel(
          tr("The numbers start again: %1 may now stand for something else than before.")
              .arg(content.name),
          this)),
      hint_(bodyLabel({}, this)),
      begin_(new QPushButton(tr("Begin"), this)),
      doneButton_(new QPushButton(tr("Done"), this)),
      decline_(new QPushButton(tr("No, go on"), this)) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(content.name);
  auto* layout = new QVBoxLayout(this);
  // A picture gets the space, and text what remains.
  layout->setSpacing(scaled(*this, picture == nullptr ? 12 : 8));
  count_ = new CutCounter(content.minimumCuts, this);
  if (picture == nullptr) {
    layout->addStretch(2);
    layout->addWidget(hugeLabel(content.name, this));
    layout->addWidget(hint_);
    layout->addWidget(count_);
  } else {
    auto* above = new QHBoxLayout;
    above->addWidget(titleLabel(content.name, this), 1);
    above->addWidget(count_, 1);
    layout->addLayout(above);
    layout->addWidget(hint_);
    layout->addWidget(picture, 1);
  }
  setCuts(0);
  if (content.isOptionalTrial) {
    count_->setCount(0, tr("Would you like to feel it once more before you choose?"));
    begin_->setText(tr("Feel it again"));
  }
  hint_->setProperty("role", QStringLiteral("statement"));
  numbering_->setProperty("role", QStringLiteral("text"));
  numbering_->setAlignment(Qt::AlignCenter);
  layout->addWidget(numbering_);
  if (picture == nullptr) hint_->setAlignment(Qt::AlignCenter);
  if (picture == nullptr) {
    // A spacer that disappears in a low window.
    constexpr int kAboveButton = 30;  // [px] at scale 1
    layout->addSpacerItem(new QSpacerItem(
        0, scaled(*this, kAboveButton), QSizePolicy::Minimum, QSizePolicy::Maximum));
  }
  for (auto* button : {begin_, doneButton_, decline_}) {
    button->setProperty("role", QStringLiteral("next"));
    layout->addWidget(button, 0, Qt::AlignCenter);
  }
  if (picture == nullptr) layout->addStretch(3);
  connect(begin_, &QPushButton::clicked, this, &TrialPage::beginRequested);
  connect(doneButton_, &QPushButton::clicked, this, &TrialPage::finishRequested);
  connect(decline_, &QPushButton::clicked, this, &TrialPage::declined);
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

QString TrialPage::cutsInWords(int cuts) const {
  const auto strokes = capitalised(asText(content_.device->strokesName.in(content_.language)));
  if (cuts == 0) return tr("%1: make %2 or more").arg(strokes).arg(content_.minimumCuts);
  return tr("%1: %2 (make %3 or more)").arg(strokes).arg(cuts).arg(content_.minimumCuts);
}

void TrialPage::setRunning(bool isRunning) {
  isRunning_ = isRunning;
  begin_->setVisible(!isRunning);
  numbering_->setVisible(!isRunning && content_.isNumberedAnew);
  doneButton_->setVisible(isRunning);
  decline_->setVisible(!isRunning && content_.isOptionalTrial);
  doneButton_->setEnabled(false);
  const auto howTo = asText(content_.device->strokeHint.in(content_.language));
  if (!isRunning) {
    hint_->setText(tr("Press Begin when you hold the instrument.") + QLatin1Char(' ') + howTo);
    begin_->setFocus();
    return;
  }
  hint_->setText(
      howTo + QLatin1Char('\n') + asText(content_.device->pointerHint.in(content_.language)));
  setFocus();
}

void TrialPage::setCuts(int cuts) {
  count_->setCount(cuts, cutsInWords(cuts));
  const bool isEnough = isRunning_ && cuts >= content_.minimumCuts;
  if (isEnough && !doneButton_->isEnabled()) {
    hint_->setText(tr("That is enough. Press Done, or feel it for longer."));
  }
  doneButton_->setEnabled(isEnough);
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
    if (!event->isAutoRepeat()) moveHandTo(1.0, kClosing);
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
    if (!event->isAutoRepeat()) moveHandTo(0.0, kOpening);
    return;
  }
  QWidget::keyReleaseEvent(event);
}

}  // namespace study::gui
