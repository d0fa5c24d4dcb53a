#include "study/gui/participant/cut_counter.h"

#include <algorithm>

#include <QEvent>
#include <QPainter>

#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {
constexpr int kRadius = 14;      // [px] at scale 1
constexpr int kBeforeWords = 4;  // [px] at scale 1, between the dots and the words
constexpr int kMostDots = 12;    // more are hard to count; the words say it as well
}  // namespace

CutCounter::CutCounter(int needed, const StrokeWords& strokes, QWidget* parent)
    : QWidget(parent), cutsNeeded_(needed), strokeWords_(strokes), words_(bodyLabel({}, this)) {
  words_->setProperty("role", QStringLiteral("count"));
  words_->setWordWrap(false);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  setCount(0);
}

int CutCounter::radius() const noexcept {
  constexpr int kLow = 480;  // [px] of a window at scale 1; the words say it as well
  return cutsNeeded_ > kMostDots || window()->height() < scaled(*this, kLow)
             ? 0
             : scaled(*this, kRadius);
}

int CutCounter::widthOfDots() const noexcept {
  return (3 * cutsNeeded_ - 1) * radius();
}

bool CutCounter::isOneLine(int width) const {
  const int between = radius() > 0 ? scaled(*this, kBeforeWords) + radius() : 0;
  return radius() == 0 || widthOfDots() + between + words_->sizeHint().width() <= width;
}

/// Puts the words beside the dots, or below them if there is no room.
void CutCounter::arrange() {
  const QSize words = words_->sizeHint();
  const int dots = radius() > 0 ? widthOfDots() + radius() + scaled(*this, kBeforeWords) : 0;
  const bool isBeside = isOneLine(width());
  const bool isMirrored = layoutDirection() == Qt::RightToLeft;
  const int top =
      isBeside ? std::max(0, (height() - words.height()) / 2) : height() - words.height();
  const int room = isBeside ? width() - dots : width();
  words_->setGeometry(isMirrored || !isBeside ? 0 : dots, top, room, words.height());
  update();
}

QSize CutCounter::sizeHint() const {
  const QSize words = words_->sizeHint();
  const int dots = radius() > 0 ? widthOfDots() + radius() + scaled(*this, kBeforeWords) : 0;
  return {dots + words.width(), minimumSizeHint().height()};
}

QSize CutCounter::minimumSizeHint() const {
  const QSize words = words_->sizeHint();
  const int dots = radius() > 0 ? 2 * radius() + scaled(*this, 2) : 0;
  const bool isBeside = width() <= 0 || isOneLine(width());
  return {
      std::max(words.width(), radius() > 0 ? widthOfDots() : 0),
      isBeside ? std::max(dots, words.height())
               : dots + scaled(*this, kBeforeWords) + words.height()};
}

void CutCounter::setCount(int made) {
  if (made == cutsMade_) return;
  cutsMade_ = made;
  words_->setText(
      made <= cutsNeeded_ ? tr("%1 of %2 %3")
                                .arg(made)
                                .arg(cutsNeeded_)
                                .arg(cutsNeeded_ == 1 ? strokeWords_.one : strokeWords_.several)
                          : tr("%1 %2").arg(made).arg(strokeWords_.several));
  updateGeometry();
  arrange();
}

void CutCounter::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  updateGeometry();
  arrange();
}

bool CutCounter::event(QEvent* event) {
  if (event->type() == QEvent::StyleChange || event->type() == QEvent::Polish) {
    updateGeometry();  // the window's scale may have changed
    arrange();
  }
  return QWidget::event(event);
}

void CutCounter::paintEvent(QPaintEvent* /*event*/) {
  const double r = radius();
  if (r <= 0.0) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const auto& theme = themeOf(*this);
  const double y = isOneLine(width()) ? 0.5 * height() : r + 1.0;
  const bool isMirrored = layoutDirection() == Qt::RightToLeft;
  for (int i = 0; i < cutsNeeded_; ++i) {
    const bool isMade = i < cutsMade_;
    const double x = (1.0 + 3.0 * i) * r;
    painter.setPen(QPen(isMade ? theme.accent.background : theme.border, 0.15 * r));
    painter.setBrush(isMade ? QBrush(theme.accent.background) : QBrush(theme.field.background));
    painter.drawEllipse(QPointF(isMirrored ? width() - x : x, y), 0.9 * r, 0.9 * r);
  }
}

}  // namespace study::gui
