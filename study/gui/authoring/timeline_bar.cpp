#include "study/gui/authoring/timeline_bar.h"

#include <cmath>
#include <utility>

#include <QPainter>

#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {

constexpr int kBarHeight = 54;  // [px]
constexpr int kScaleHeight = 26;
constexpr int kTickLength = 6;

/// The interval between tick marks [min], chosen so that their numbers have room.
/// @param perMinute  [px]
int minutesBetweenMarks(double perMinute) {
  constexpr double kRoom = 52.0;  // [px]: of "0 min"
  for (const int step : {1, 2, 5, 10, 15, 30}) {
    if (step * perMinute >= kRoom) return step;
  }
  return 60;
}

}  // namespace

TimelineBar::TimelineBar(QWidget* parent) : QWidget(parent) {
  setMinimumHeight(kBarHeight + kScaleHeight);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize TimelineBar::sizeHint() const {
  return {400, kBarHeight + kScaleHeight};
}

void TimelineBar::show(std::vector<Part> parts) {
  parts_ = std::move(parts);
  whole_ = 0.0;
  QString words;
  for (const auto& part : parts_) {
    whole_ += part.seconds;
    words += tr("%1: %2 minutes. ").arg(part.name).arg(part.seconds / 60.0, 0, 'f', 1);
  }
  setAccessibleName(tr("Timeline of a session"));
  setAccessibleDescription(words);
  update();
}

void TimelineBar::paintEvent(QPaintEvent* /*event*/) {
  if (whole_ <= 0.0) return;
  const auto& colours = themeOf(*this);
  QPainter painter(this);
  const double perSecond = (width() - 1.0) / whole_;
  double begin = 0.0;
  for (const auto& part : parts_) {
    const QRectF box(begin * perSecond, 0.0, part.seconds * perSecond, kBarHeight);
    const auto& fill = part.isFelt ? colours.accent : colours.field;
    painter.setPen(colours.border);
    painter.setBrush(fill.background);
    painter.drawRect(box);
    painter.setPen(fill.text);
    const auto inside = box.adjusted(4, 2, -4, -2);
    const int wide = painter.fontMetrics().horizontalAdvance(part.name);
    if (wide < inside.width()) painter.drawText(inside, Qt::AlignCenter, part.name);
    begin += part.seconds;
  }
  painter.setPen(colours.quiet);
  const int step = minutesBetweenMarks(60.0 * perSecond);
  for (int minute = 0; minute * 60.0 <= whole_; minute += step) {
    const double x = minute * 60.0 * perSecond;
    painter.drawLine(QPointF(x, kBarHeight), QPointF(x, kBarHeight + kTickLength));
    const QString words = minute == 0 ? tr("0 min") : QString::number(minute);
    const double left = std::min(x + 2.0, width() - 30.0);
    painter.drawText(QPointF(left, kBarHeight + kScaleHeight - 6.0), words);
  }
}

}  // namespace study::gui
