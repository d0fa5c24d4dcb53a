#include "study/report/figures/rows_canvas.h"

#include "study/report/figures/svg_canvas.h"

namespace study::report {
namespace {

constexpr int kFewTicks = 6;

}  // namespace

void RowsCanvas::heading(const std::string& text) {
  painter_.setPen(Qt::black);
  drawText(
      painter_,
      {0, y_, width_, kHeading},
      Qt::AlignLeft | Qt::AlignVCenter,
      QString::fromStdString(text),
      true);
  skip(kHeading);
}

void RowsCanvas::name(const std::string& text) {
  painter_.setPen(Qt::black);
  drawText(
      painter_,
      isNarrow_ ? QRectF(0, y_, width_, kNameLine) : QRectF(0, y_, left_ - 14, drawing_),
      Qt::AlignVCenter | (isNarrow_ ? Qt::AlignLeft : Qt::AlignRight | Qt::TextWordWrap),
      QString::fromStdString(text));
}

void RowsCanvas::words(const std::string& text) {
  painter_.setPen(Qt::black);
  drawText(
      painter_,
      isNarrow_ ? QRectF(0, y_, width_, kNameLine)
                : QRectF(right_ + 14, y_, width_ - right_ - 14, drawing_),
      Qt::AlignVCenter | (isNarrow_ ? Qt::AlignRight : Qt::AlignLeft),
      QString::fromStdString(text));
}

void RowsCanvas::axis(double top, double bottom, const std::string& title, const QString& suffix) {
  for (const auto& tick : isNarrow_ ? scale_.ticks(kFewTicks) : scale_.ticks()) {
    const double at = x(tick.value);
    painter_.setPen(QPen(QColor(226, 226, 226), 1));
    painter_.drawLine(QPointF(at, top), QPointF(at, bottom));
    painter_.setPen(Qt::black);
    drawText(painter_, {at - 36, bottom + 3, 72, 18}, Qt::AlignCenter, tick.text + suffix);
  }
  drawText(
      painter_,
      isNarrow_ ? QRectF(0, bottom + 22, width_, 20)
                : QRectF(left_, bottom + 22, right_ - left_, 20),
      Qt::AlignCenter,
      QString::fromStdString(title));
}

void RowsCanvas::reference(double value, double top, double bottom, Qt::PenStyle style) {
  painter_.setPen(QPen(QColor(70, 70, 70), 1.2, style));
  painter_.drawLine(QPointF(x(value), top), QPointF(x(value), bottom));
}

void RowsCanvas::interval(
    double low, double high, double y, const QColor& colour, double thickness) {
  painter_.setPen(QPen(colour, thickness, Qt::SolidLine, Qt::FlatCap));
  painter_.drawLine(QPointF(x(low), y), QPointF(x(high), y));
  painter_.setPen(QPen(colour, 1.2));
  for (const double end : {low, high}) {
    painter_.drawLine(QPointF(x(end), y - 4), QPointF(x(end), y + 4));
  }
}

void RowsCanvas::dot(double value, double y, const QColor& colour, double radius) {
  painter_.setPen(QPen(Qt::white, 1));
  painter_.setBrush(colour);
  painter_.drawEllipse(QPointF(x(value), y), radius, radius);
}

}  // namespace study::report
