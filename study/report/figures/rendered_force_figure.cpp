#include <algorithm>
#include <cmath>
#include <numbers>

#include <QPainterPath>

#include "study/report/figures/axis_scale.h"
#include "study/report/figures/figures.h"
#include "study/report/figures/palette.h"
#include "study/report/figures/svg_canvas.h"

namespace study::report {
namespace {

constexpr double kFigureHeight = 290.0;
constexpr double kForceAxisHeight = 52.0;         // below the plot
constexpr double kForceLegendEntryHeight = 24.0;  // of a legend below the plot
constexpr std::size_t kMarks = 8;                 // along a line
constexpr double kMark = 5.5;                     // radius

/// The plot; a narrow figure has its legend below, others beside.
QRectF renderedForcePlotOf(const FigureFormat& format) {
  constexpr double kLeft = 64.0;
  constexpr double kTop = 14.0;
  constexpr double kUsual = 540.0;
  constexpr double kUsualHeight = 220.0;
  constexpr double kLegend = FigureFormat::kUsualWidth - kLeft - kUsual;
  if (!format.isNarrow())
    return {kLeft, kTop, format.layoutWidth() - kLeft - kLegend, kUsualHeight};
  const double width = format.layoutWidth() - kLeft - kTop;
  return {kLeft, kTop, width, width * kUsualHeight / kUsual};
}

bool isOf(const RenderedForceCurve& curve, const std::string& device) {
  return curve.device == device && !curve.points.empty();
}

/// Paints the curves of one device.
class RenderedForcePainter {
 public:
  RenderedForcePainter(
      QPainter& painter,
      const ReportSection& section,
      const std::string& device,
      const FigureFormat& format)
      : painter_(painter), section_(section), format_(format), plot_(renderedForcePlotOf(format)) {
    for (const auto& curve : section.curves) {
      if (!isOf(curve, device)) continue;
      curves_.push_back(&curve);
      for (const auto& point : curve.points) {
        largestTravel_ = std::max(largestTravel_, point.travel);
        largestForce_ = std::max(largestForce_, point.high);
      }
      for (const double force : curve.intended) largestForce_ = std::max(largestForce_, force);
    }
    shown_ = &section.protocol.device(device)->kind->shown;
  }

  void paint() {
    axes();
    for (const auto* curve : curves_) band(*curve);
    for (const auto* curve : curves_) line(*curve);
    for (const auto* curve : curves_) intended(*curve);
    legend();
  }

 private:
  QPointF at(double travel, double force) const {
    return {
        plot_.left() + plot_.width() * travel / std::max(largestTravel_ * 1.02, 1e-12),
        plot_.bottom() - plot_.height() * force / std::max(largestForce_ * 1.08, 1e-12)};
  }

  void axes() {
    const double shown = std::max(largestTravel_ * shown_->factor, 1e-9);
    const double most = std::max(largestForce_, 1e-9);
    for (const auto& tick :
         AxisScale({.title = {}, .least = 0.0}, 0.0, shown).ticks(format_.isNarrow() ? 4 : 8)) {
      const auto p = at(tick.value / shown_->factor, 0.0);
      grid(p, {p.x(), plot_.top()});
      painter_.setPen(Qt::black);
      drawText(painter_, {p.x() - 30, plot_.bottom() + 4, 60, 18}, Qt::AlignCenter, tick.text);
    }
    for (const auto& tick : AxisScale({.title = {}, .least = 0.0}, 0.0, most).ticks(6)) {
      const auto p = at(0.0, tick.value);
      grid(p, {plot_.right(), p.y()});
      painter_.setPen(Qt::black);
      drawText(
          painter_,
          {4, p.y() - 9, plot_.left() - 12, 18},
          Qt::AlignRight | Qt::AlignVCenter,
          tick.text);
    }
    drawText(
        painter_,
        {plot_.left(), plot_.bottom() + 26, plot_.width(), 20},
        Qt::AlignCenter,
        QString::fromStdString(section_.words(shown_->axis)));
    painter_.save();
    painter_.translate(14, plot_.center().y());
    painter_.rotate(-90);
    drawText(
        painter_,
        {-100, -10, 200, 20},
        Qt::AlignCenter,
        QString::fromStdString(section_.words("force [N]")));
    painter_.restore();
  }

  void grid(const QPointF& from, const QPointF& to) {
    painter_.setPen(QPen(QColor(225, 225, 225), 1));
    painter_.drawLine(from, to);
  }

  QColor colourOf(const RenderedForceCurve& curve) const {
    return categoryColour(section_.conditionIndex(curve.condition));
  }

  void band(const RenderedForceCurve& curve) {
    QPainterPath path(at(curve.points.front().travel, curve.points.front().low));
    for (const auto& point : curve.points) path.lineTo(at(point.travel, point.low));
    const std::vector back(curve.points.rbegin(), curve.points.rend());
    for (const auto& point : back) path.lineTo(at(point.travel, point.high));
    auto colour = colourOf(curve);
    colour.setAlphaF(0.16F);
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(colour);
    painter_.drawPath(path);
  }

  void line(const RenderedForceCurve& curve) {
    QPainterPath path(at(curve.points.front().travel, curve.points.front().median));
    for (const auto& point : curve.points) path.lineTo(at(point.travel, point.median));
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(QPen(colourOf(curve), 2.2));
    painter_.drawPath(path);
    const std::size_t step = std::max<std::size_t>(curve.points.size() / kMarks, 1);
    for (std::size_t i = step / 2; i < curve.points.size(); i += step) {
      mark(curve, at(curve.points[i].travel, curve.points[i].median));
    }
  }

  /// A mark of the condition, so that lines differ by more than their colour: a regular polygon of
  /// three corners for the first condition, four for the second, and so on.
  void mark(const RenderedForceCurve& curve, const QPointF& where) {
    const int corners = 3 + section_.conditionIndex(curve.condition) % 5;
    QPolygonF polygon;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / corners - 0.5 * std::numbers::pi;
      polygon << where + kMark * QPointF(std::cos(angle), std::sin(angle));
    }
    painter_.setPen(QPen(Qt::white, 0.8));
    painter_.setBrush(colourOf(curve));
    painter_.drawPolygon(polygon);
    painter_.setBrush(Qt::NoBrush);
  }

  void intended(const RenderedForceCurve& curve) {
    if (curve.intended.empty()) return;
    QPainterPath path(at(curve.points.front().travel, curve.intended.front()));
    for (std::size_t i = 0; i < curve.intended.size(); ++i) {
      path.lineTo(at(curve.points[i].travel, curve.intended[i]));
    }
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(QPen(colourOf(curve), 1.2, Qt::DashLine));
    painter_.drawPath(path);
  }

  /// The line and the mark of a curve.
  void entry(const RenderedForceCurve& curve, const QPointF& where, double length) {
    painter_.setPen(QPen(colourOf(curve), 3));
    painter_.drawLine(where, where + QPointF(length, 0));
    mark(curve, where + QPointF(length / 2, 0));
    painter_.setPen(Qt::black);
  }

  void legendText(const QRectF& where, const std::string& text) {
    drawText(painter_, where, Qt::AlignLeft | Qt::AlignVCenter, QString::fromStdString(text));
  }

  void legend() {
    const bool isBelow = format_.isNarrow();
    const double x = isBelow ? plot_.left() : plot_.right() + 18;
    double y = isBelow ? plot_.bottom() + kForceAxisHeight : plot_.top() + 6;
    for (const auto* curve : curves_) {
      const auto title = section_.conditionTitle(curve->condition);
      const auto strokes =
          section_.words.count(curve->strokes, "{} cut or stroke", "{} cuts or strokes");
      if (isBelow) {
        entry(*curve, {x, y + 11}, 22);
        legendText({x + 30, y, plot_.width() - 30, 20}, title + ", " + strokes);
        y += kForceLegendEntryHeight;
      } else {
        const double width = format_.layoutWidth() - x - 34;
        entry(*curve, {x, y + 10}, 26);
        legendText({x + 34, y, width, 20}, title);
        legendText({x + 34, y + 17, width, 18}, strokes);
        y += 44;
      }
    }
  }

  QPainter& painter_;
  const ReportSection& section_;
  FigureFormat format_;
  QRectF plot_;
  std::vector<const RenderedForceCurve*> curves_;
  double largestTravel_ = 0.0;
  double largestForce_ = 0.0;
  const haptics::devices::DeviceKind::TravelDisplay* shown_ = nullptr;  ///< unit of travel
};

QSizeF renderedForceSizeOf(
    const ReportSection& section, const std::string& device, const FigureFormat& format) {
  if (!format.isNarrow()) return {format.layoutWidth(), kFigureHeight};
  const auto entries = std::ranges::count_if(
      section.curves, [&](const RenderedForceCurve& curve) { return isOf(curve, device); });
  const double legend = kForceLegendEntryHeight * static_cast<double>(entries);
  return {
      format.layoutWidth(), renderedForcePlotOf(format).bottom() + kForceAxisHeight + legend + 6.0};
}

}  // namespace

std::string renderedForceFigure(
    const ReportSection& section, const std::string& device, const FigureFormat& format) {
  return asSvg(
      renderedForceSizeOf(section, device, format),
      [&](QPainter& painter) { RenderedForcePainter(painter, section, device, format).paint(); },
      format);
}

}  // namespace study::report
