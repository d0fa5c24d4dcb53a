#include "study/gui/operator/servo_panel.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>

#include "haptics/registry/device_kinds.h"
#include "study/gui/operator/travel_scale.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/theme.h"
#include "study/model/trial_record.h"

namespace study::gui {

/// A histogram of lateness with one bar per range. Heights are logarithmic, so that one late tick
/// in a million is visible.
class ServoPanel::Bars final : public QWidget {
 public:
  Bars(const ServoHealth& health, QWidget* parent) : QWidget(parent), health_(health) {
    setMinimumSize(230, 96);
  }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    if (health_.ticks() == 0) return;
    QPainter painter(this);
    QFont small = font();
    small.setPixelSize(10);
    painter.setFont(small);
    const auto& colours = themeOf(*this);
    painter.setPen(colours.window.text);
    const auto& bars = health_.bars();
    const double wide = static_cast<double>(width()) / static_cast<double>(bars.size());
    constexpr double kFoot = 14.0;
    const QString caption = ServoPanel::tr("ticks by lateness [µs], log scale");
    painter.drawText(QRectF(0, 0, width(), kFoot), Qt::AlignRight | Qt::AlignVCenter, caption);
    const double most = std::log10(1.0 + static_cast<double>(health_.ticks()));
    for (std::size_t i = 0; i < bars.size(); ++i) {
      const double left = wide * static_cast<double>(i);
      const double share = most > 0.0 ? std::log10(1.0 + static_cast<double>(bars[i])) / most : 0.0;
      const double high = share * (height() - 2.0 * kFoot);
      const bool isLate = i + 1 == bars.size();
      painter.fillRect(
          QRectF(left + 2, height() - kFoot - high, wide - 4, high),
          isLate ? colours.bad.background : colours.force);
      const QString edge = isLate ? QStringLiteral("> %1").arg(ServoHealth::kEdges.back())
                                  : QString::number(ServoHealth::kEdges[i]);
      painter.drawText(QRectF(left, height() - kFoot, wide, kFoot), Qt::AlignCenter, edge);
    }
  }

 private:
  const ServoHealth& health_;
};

ServoPanel::ServoPanel(QWidget* parent)
    : QWidget(parent),
      timingLabel_(new QLabel(this)),
      limitLabel_(new QLabel(this)),
      details_(new QPushButton(tr("Details"), this)),
      more_(new QWidget(this)),
      words_(quietLabel({}, this)),
      bars_(new Bars(health_, this)) {
  timingLabel_->setObjectName(QStringLiteral("timing"));
  limitLabel_->setObjectName(QStringLiteral("limit"));
  for (auto* label : {timingLabel_, limitLabel_})
    label->setWordWrap(true);  // the operator's window is narrow beside a participant's
  setRole(*limitLabel_, "warn");
  details_->setObjectName(QStringLiteral("timing-details"));
  details_->setProperty("role", QStringLiteral("tool"));
  details_->setCheckable(true);
  auto* head = new QHBoxLayout;
  auto* lights = new QVBoxLayout;
  lights->addWidget(timingLabel_);
  lights->addWidget(limitLabel_);
  head->addLayout(lights, 1);
  head->addWidget(details_);
  auto* all = withoutMargins<QVBoxLayout>(this);
  all->addLayout(head);
  all->addWidget(more_);
  more_->setVisible(false);
  connect(details_, &QPushButton::toggled, more_, &QWidget::setVisible);
  auto* layout = withoutMargins<QHBoxLayout>(more_);
  words_->setObjectName(QStringLiteral("servo-health"));
  words_->setWordWrap(true);
  layout->addWidget(words_, 3);
  layout->addWidget(bars_, 2);
  bars_->setToolTip(tr("Ticks by how late they began [µs]; heights are logarithmic"));
  begin(*haptics::deviceKinds().front(), 0.0);
}

void ServoPanel::begin(const haptics::devices::DeviceKind& device, double rate) {
  energyUnit_ = travelScaleOf(device).energyUnit;
  health_ = {};
  nominalRate_ = rate;
  rate_ = 0.0;
  ticksBefore_ = 0;
  sinceRate_.start();
  refresh();
}

void ServoPanel::showForces(bool areShown) {
  areForcesShown_ = areShown;
  refresh();
}

void ServoPanel::refresh() {
  if (sinceRate_.elapsed() >= 1000) {
    const double seconds = static_cast<double>(sinceRate_.restart()) / 1000.0;
    rate_ = static_cast<double>(health_.ticks() - ticksBefore_) / seconds;
    ticksBefore_ = health_.ticks();
  }
  const QString priority = isRealtime_ ? tr("real-time priority") : tr("ordinary priority");
  QString lines = tr("Rate: %1 of %2 Hz, %7\n"
                     "Delay: median %3, 99 % within %4, largest %5 µs\n"
                     "No measurement: %6 % of the ticks")
                      .arg(rate_ > 0.0 ? QString::number(rate_, 'f', 0) : QStringLiteral("—"))
                      .arg(nominalRate_, 0, 'f', 0)
                      .arg(health_.lateness(0.5), 0, 'f', 0)
                      .arg(health_.lateness(0.99), 0, 'f', 0)
                      .arg(health_.largestLateness(), 0, 'f', 0)
                      .arg(100.0 * health_.invalidShare(), 0, 'f', 1)
                      .arg(priority);
  const QString forces = tr("Force at its limit: %1 % of the time\n"
                            "Energy of the contact: %2 %4, least %3 %4")
                             .arg(100.0 * health_.saturatedShare(), 0, 'f', 1)
                             .arg(health_.energy(), 0, 'f', 2)
                             .arg(health_.leastEnergy(), 0, 'f', 2)
                             .arg(energyUnit_);
  if (areForcesShown_) lines += u'\n' + forces;
  const auto energy =
      tr("Energy of the current contact; it restarts when the tool leaves the surface");
  words_->setToolTip(areForcesShown_ ? energy : QString());
  showTimingStatus();
  showLimits();
  words_->setText(health_.ticks() == 0 ? tr("Nothing is felt just now.") : lines);
  // In a narrow window the lines wrap, for which the panel's own minimum height does not allow.
  constexpr int kUsualWidth = 300;  // [px], until the panel has been laid out
  words_->setMinimumHeight(words_->heightForWidth(std::max(words_->width(), kUsualWidth)));
  bars_->update();
}

/// One line: whether the trial will get a warning for its timing (TrialRecord::judgement()), and
/// the numbers behind it.
void ServoPanel::showTimingStatus() {
  constexpr double kMostInvalid = 0.01;
  const auto ticks = static_cast<std::int64_t>(health_.ticks());
  const auto late = static_cast<std::int64_t>(health_.bars().back());
  if (ticks == 0) {
    setRole(*timingLabel_, "quiet");
    return timingLabel_->setText(tr("No trial is running."));
  }
  if (isOftenLate(late, ticks) || health_.invalidShare() > kMostInvalid) {
    setRole(*timingLabel_, "bad");
    return timingLabel_->setText(
        tr("✖ Timing: poor (%1 of %2 force updates late)").arg(late).arg(ticks));
  }
  setRole(*timingLabel_, "good");
  timingLabel_->setText(
      late > 0 ? tr("● Timing: good (%1 of %2 force updates late)").arg(late).arg(ticks)
               : tr("● Timing: good (none of %1 force updates late)").arg(ticks));
}

/// Mentions a force at its limit however briefly, because what is felt then is not what the scene
/// asked for.
void ServoPanel::showLimits() {
  QStringList words;
  if (areForcesShown_ && health_.saturatedTicks() > 0)
    words << tr("▲ Force at its limit: %1 updates").arg(health_.saturatedTicks());
  if (health_.leaps() > 0)
    words << tr("▲ Leaps of the position: %1, check the encoder's cable").arg(health_.leaps());
  limitLabel_->setText(words.join(u'\n'));
  limitLabel_->setVisible(!words.isEmpty());
}

}  // namespace study::gui
