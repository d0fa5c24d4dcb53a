#include "study/gui/authoring/timeline_bar.h"

#include <cmath>
#include <utility>

#include <QPainter>

#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {

constexpr int kNameHeight = 30;  // [px]
constexpr int kFilledHeight = 24;
constexpr int kBarHeight = kNameHeight + kFilledHeight;
constexpr int kScaleHeight = 26;
constexpr int kTickLength = 6;

/// The interval between tick marks [min], chosen so that their numbers have room.
/// @param perMinute  [px]
int minutesBetweenMarks(double perMinute) {
  constexpr double kRoom = 52.0;  // [px]: width of "0 min"
  for (const int step : {1, 2, 5, 10, 15, 30}) {
    if (step * perMinute >= kRoom) return step;
  }
  return 60;
}

}  // namespace

double TimelineBar::Part::seconds() const noexcept {
  double sum = 0.0;
  for (const auto& stretch : periods) sum += stretch.seconds;
  return sum;
}

TimelineBar::TimelineBar(QWidget* parent) : QWidget(parent) {
  setMinimumHeight(kBarHeight + kScaleHeight);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize TimelineBar::sizeHint() const {
  return {400, kBarHeight + kScaleHeight};
}

void TimelineBar::show(std::vector<Part> parts) {
  parts_ = std::move(parts);
  totalSeconds_ = 0.0;
  QString words;
  for (const auto& part : parts_) {
    totalSeconds_ += part.seconds();
    words += tr("%1: %2 minutes. ").arg(part.name).arg(part.seconds() / 60.0, 0, 'f', 1);
  }
  setAccessibleName(tr("Timeline of a session"));
  setAccessibleDescription(words);
  update();
}

void TimelineBar::paintEvent(QPaintEvent* /*event*/) {
  if (totalSeconds_ <= 0.0) return;
  const auto& colours = themeOf(*this);
  QPainter painter(this);
  const double perSecond = (width() - 1.0) / totalSeconds_;
  double begin = 0.0;
  int number = 0;
  for (const auto& part : parts_) {
    const QRectF box(begin * perSecond, 0.0, part.seconds() * perSecond, kBarHeight);
    painter.fillRect(box, colours.field.background);
    for (const auto& [seconds, isOnDevice] : part.periods) {
      const QRectF below(begin * perSecond, kNameHeight, seconds * perSecond, kFilledHeight);
      if (isOnDevice) painter.fillRect(below, colours.accent.background);
      begin += seconds;
    }
    painter.setPen(colours.border);
    painter.drawRect(box);
    painter.setPen(colours.field.text);
    const QRectF above(box.left(), 0.0, box.width(), kNameHeight);
    const QString digits = QString::number(++number);
    for (const QString& words : {digits + QLatin1Char(' ') + part.name, digits}) {
      if (painter.fontMetrics().horizontalAdvance(words) >= above.width()) continue;
      painter.drawText(above, Qt::AlignCenter, words);
      break;
    }
  }
  painter.setPen(colours.quiet);
  const int step = minutesBetweenMarks(60.0 * perSecond);
  for (int minute = 0; minute * 60.0 <= totalSeconds_; minute += step) {
    const double x = minute * 60.0 * perSecond;
    painter.drawLine(QPointF(x, kBarHeight), QPointF(x, kBarHeight + kTickLength));
    const QString words = minute == 0 ? tr("0 min") : QString::number(minute);
    const double left = std::min(x + 2.0, width() - 30.0);
    painter.drawText(QPointF(left, kBarHeight + kScaleHeight - 6.0), words);
  }
}

}  // namespace study::gui
