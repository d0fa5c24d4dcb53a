#include "study/report/figures/chart_painter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QPainterPath>

#include "study/report/figures/axis_scale.h"
#include "study/report/figures/palette.h"
#include "study/report/figures/svg_canvas.h"

namespace study::report {
namespace {

constexpr QSizeF kSize{860.0, 440.0};
constexpr QRectF kPlot{78.0, 16.0, 540.0, 360.0};  // the legend is beside it
constexpr double kMarker = 4.0;
constexpr std::size_t kColours = 7;  // of the palette

struct Range {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();

  void include(double value, bool isLogarithmic) {
    if (!std::isfinite(value) || (isLogarithmic && !(value > 0.0))) return;
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

AxisScale scaleOf(const Chart& chart, bool isX) {
  const ChartAxis& axis = isX ? chart.x : chart.y;
  Range range;
  for (const auto& series : chart.series) {
    for (const auto& point : series.points) {
      range.include(isX ? point.x : point.y, axis.isLogarithmic);
      if (isX && point.xHigh) range.include(*point.xHigh, axis.isLogarithmic);
    }
  }
  if (!(range.least <= range.most)) return {axis, 1.0, 10.0};
  if (range.least == range.most && axis.isLogarithmic)
    return {axis, range.least / 2, range.most * 2};
  return {axis, range.least, range.most};
}

class ChartPainter {
 public:
  ChartPainter(QPainter& painter, const Chart& chart)
      : painter_(painter), chart_(chart), x_(scaleOf(chart, true)), y_(scaleOf(chart, false)) {}

  void paint() {
    axes();
    painter_.save();
    painter_.setClipRect(kPlot.adjusted(-6, -6, 6, 6));
    for (std::size_t i = 0; i < chart_.series.size(); ++i)
      series(chart_.series[i], colourOf(i), i >= kColours);
    painter_.restore();
    legend();
  }

 private:
  QColor colourOf(std::size_t index) const {
    return categoryColour(chart_.series[index].colour.value_or(static_cast<int>(index)));
  }

  QPointF at(double x, double y) const {
    return {
        kPlot.left() + kPlot.width() * x_.place(x), kPlot.bottom() - kPlot.height() * y_.place(y)};
  }
  bool shows(const ChartPoint& point) const { return x_.shows(point.x) && y_.shows(point.y); }

  void axes() {
    const QPen grid(QColor(226, 226, 226), 1);
    for (const auto& tick : x_.ticks()) {
      const double x = kPlot.left() + kPlot.width() * x_.place(tick.value);
      painter_.setPen(grid);
      painter_.drawLine(QPointF(x, kPlot.top()), QPointF(x, kPlot.bottom()));
      painter_.setPen(Qt::black);
      drawText(painter_, {x - 36, kPlot.bottom() + 4, 72, 18}, Qt::AlignCenter, tick.text);
    }
    for (const auto& tick : y_.ticks()) {
      const double y = kPlot.bottom() - kPlot.height() * y_.place(tick.value);
      painter_.setPen(grid);
      painter_.drawLine(QPointF(kPlot.left(), y), QPointF(kPlot.right(), y));
      painter_.setPen(Qt::black);
      drawText(
          painter_,
          {22, y - 9, kPlot.left() - 30, 18},
          Qt::AlignRight | Qt::AlignVCenter,
          tick.text);
    }
    drawText(
        painter_,
        {kPlot.left(), kPlot.bottom() + 28, kPlot.width(), 20},
        Qt::AlignCenter,
        QString::fromStdString(chart_.x.title));
    painter_.save();
    painter_.translate(14, kPlot.center().y());
    painter_.rotate(-90);
    drawText(
        painter_,
        {-kPlot.height() / 2 - 20, -10, kPlot.height() + 40, 20},
        Qt::AlignCenter,
        QString::fromStdString(chart_.y.title));
    painter_.restore();
  }

  static bool isJoined(const ChartSeries& series) {
    return series.style != ChartSeries::Style::Markers;
  }
  static bool isMarked(const ChartSeries& series) {
    return !isJoined(series) || series.style == ChartSeries::Style::LineAndMarkers;
  }
  static Qt::PenStyle penOf(const ChartSeries& series) {
    return series.style == ChartSeries::Style::Dashed ? Qt::DashLine : Qt::SolidLine;
  }

  void series(const ChartSeries& series, const QColor& colour, bool isOfSecondRound) {
    if (isJoined(series)) {
      painter_.setBrush(Qt::NoBrush);
      const auto style = penOf(series);
      painter_.setPen(QPen(colour, style == Qt::DashLine ? 1.6 : 2.0, style));
      line(series);
    }
    for (const auto& point : series.points) {
      if (shows(point)) mark(point, colour, isMarked(series), isOfSecondRound);
    }
  }

  void line(const ChartSeries& series) {
    QPainterPath path;
    bool isDrawing = false;
    for (const auto& point : series.points) {
      if (!shows(point)) {
        isDrawing = false;
        continue;
      }
      const QPointF here = at(point.x, point.y);
      isDrawing ? path.lineTo(here) : path.moveTo(here);
      isDrawing = true;
    }
    painter_.drawPath(path);
  }

  void mark(const ChartPoint& point, const QColor& colour, bool isMarked, bool isSquare) {
    const QPointF here = at(point.x, point.y);
    if (point.xHigh && x_.shows(*point.xHigh)) {
      const QPointF end = at(*point.xHigh, point.y);
      painter_.setPen(QPen(colour, 1));
      painter_.drawLine(here, end);
      painter_.drawLine(end - QPointF(0, 3), end + QPointF(0, 3));
    }
    if (isMarked) {
      painter_.setPen(Qt::NoPen);
      painter_.setBrush(colour);
      symbol(here, isSquare);
    }
    if (point.label.empty()) return;
    painter_.setPen(colour.darker(120));
    drawText(
        painter_,
        {here.x() + 6, here.y() - 17, 120, 14},
        Qt::AlignLeft | Qt::AlignVCenter,
        QString::fromStdString(point.label));
  }

  /// When the colours repeat, squares distinguish the second round from the first.
  void symbol(const QPointF& where, bool isSquare) {
    if (isSquare) {
      painter_.drawRect(QRectF(where.x() - kMarker, where.y() - kMarker, 2 * kMarker, 2 * kMarker));
    } else {
      painter_.drawEllipse(where, kMarker, kMarker);
    }
  }

  void legend() {
    constexpr double kLeft = kPlot.right() + 20;
    double y = kPlot.top() + 2;
    for (std::size_t i = 0; i < chart_.series.size(); ++i) {
      const auto& series = chart_.series[i];
      if (series.title.empty()) continue;
      if (isJoined(series)) {
        painter_.setPen(QPen(colourOf(i), 2.4, penOf(series)));
        painter_.drawLine(QPointF(kLeft, y + 10), QPointF(kLeft + 24, y + 10));
      }
      if (isMarked(series)) {
        painter_.setPen(Qt::NoPen);
        painter_.setBrush(colourOf(i));
        symbol(QPointF(kLeft + 12, y + 10), i >= kColours);
      }
      painter_.setPen(Qt::black);
      drawText(
          painter_,
          {kLeft + 32, y + 1, kSize.width() - kLeft - 34, 34},
          Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap,
          QString::fromStdString(series.title));
      y += series.title.size() > 26 ? 38.0 : 24.0;
    }
  }

  QPainter& painter_;
  const Chart& chart_;
  AxisScale x_;
  AxisScale y_;
};

}  // namespace

std::string chartAsSvg(const Chart& chart) {
  return asSvg(kSize, [&](QPainter& painter) { ChartPainter(painter, chart).paint(); });
}

}  // namespace study::report
