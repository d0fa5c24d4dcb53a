#include "study/gui/participant/cut_counter.h"

#include <algorithm>

#include <QEvent>
#include <QPainter>
#include <QVBoxLayout>

#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {
constexpr int kRadius = 16;    // [px] at scale 1
constexpr int kMostDots = 12;  // more are hard to count; the words say it as well
}  // namespace

CutCounter::CutCounter(int needed, QWidget* parent)
    : QWidget(parent), cutsNeeded_(needed), words_(bodyLabel({}, this)) {
  words_->setProperty("role", QStringLiteral("count"));
  words_->setAlignment(Qt::AlignCenter);
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(0);
  layout->addWidget(words_);
  makeRoomForDots();
}

int CutCounter::radius() const noexcept {
  constexpr int kLow = 480;  // [px] of a window; the words say it as well
  return cutsNeeded_ > kMostDots || window()->height() < kLow ? 0 : scaled(*this, kRadius);
}

void CutCounter::makeRoomForDots() {
  layout()->setContentsMargins(0, 3 * radius(), 0, 0);
}

void CutCounter::setCount(int made, const QString& words) {
  words_->setText(words);
  if (made == cutsMade_) return;
  cutsMade_ = made;
  update();
}

bool CutCounter::event(QEvent* event) {
  // The window's scale or its height may have changed.
  if (event->type() == QEvent::StyleChange || event->type() == QEvent::Resize) makeRoomForDots();
  return QWidget::event(event);
}

void CutCounter::paintEvent(QPaintEvent* /*event*/) {
  const double r = radius();
  if (r <= 0.0) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const auto& theme = themeOf(*this);
  const double first = 0.5 * width() - 1.5 * r * (cutsNeeded_ - 1);
  for (int i = 0; i < cutsNeeded_; ++i) {
    const bool isMade = i < cutsMade_;
    painter.setPen(QPen(isMade ? theme.accent.background : theme.border, 0.15 * r));
    painter.setBrush(isMade ? QBrush(theme.accent.background) : QBrush(theme.field.background));
    painter.drawEllipse(QPointF(first + 3.0 * r * i, 1.2 * r), r, r);
  }
}

}  // namespace study::gui
