#include "study/gui/participant/answer_slider.h"

#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {
constexpr int kMargin = 18;  // [px]: a handle's radius and its distance from the edge
}

AnswerSlider::AnswerSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  setProperty("role", QStringLiteral("answer"));
  setFocusPolicy(Qt::StrongFocus);
  connect(this, &QSlider::valueChanged, this, [this](int position) {
    isTouched_ = true;  // also when a screen reader moved it
    emit answered(position);
  });
}

void AnswerSlider::setAnswer(int position) {
  isTouched_ = true;
  const QSignalBlocker quiet(this);
  setValue(position);
  update();
}

void AnswerSlider::setFromPosition(const QPointF& position) {
  const int margin = scaled(*this, kMargin);
  const double share = (position.x() - margin) / std::max(1, width() - 2 * margin);
  const double mirrored = layoutDirection() == Qt::RightToLeft ? 1.0 - share : share;
  const int wanted = static_cast<int>(
      std::lround(minimum() + std::clamp(mirrored, 0.0, 1.0) * (maximum() - minimum())));
  if (wanted == value() && !isTouched_) {
    isTouched_ = true;
    emit answered(wanted);
  }
  setValue(wanted);
  update();
}

void AnswerSlider::mousePressEvent(QMouseEvent* event) {
  setFromPosition(event->position());
}

void AnswerSlider::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) != 0) setFromPosition(event->position());
}

void AnswerSlider::keyPressEvent(QKeyEvent* event) {
  const bool moves = event->key() == Qt::Key_Left || event->key() == Qt::Key_Right ||
                     event->key() == Qt::Key_Home || event->key() == Qt::Key_End;
  if (moves && !isTouched_) {
    // The first key press puts the handle in the middle; later ones move it.
    setFromPosition(QPointF(width() / 2.0, height() / 2.0));
    return;
  }
  QSlider::keyPressEvent(event);
}

void AnswerSlider::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double y = height() / 2.0;
  const double left = scaled(*this, kMargin);
  const double right = width() - left;
  const double tick = 0.5 * left;
  painter.setPen(QPen(themeOf(*this).border, scaled(*this, 3)));
  painter.drawLine(QPointF(left, y), QPointF(right, y));
  for (const double x : {left, (left + right) / 2.0, right}) {
    painter.drawLine(QPointF(x, y - tick), QPointF(x, y + tick));
  }
  if (hasFocus()) {
    painter.setPen(QPen(themeOf(*this).focus, 3));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(2, 2, -2, -2), 8, 8);
  }
  if (!isTouched_) return;
  const double share =
      static_cast<double>(value() - minimum()) / std::max(1, maximum() - minimum());
  const double place = layoutDirection() == Qt::RightToLeft ? 1.0 - share : share;
  painter.setPen(Qt::NoPen);
  painter.setBrush(themeOf(*this).accent.background);
  const double radius = 0.78 * left;
  painter.drawEllipse(QPointF(left + place * (right - left), y), radius, radius);
}

}  // namespace study::gui
