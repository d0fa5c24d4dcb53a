#include <algorithm>
#include <cmath>

#include "study/report/figures/figures.h"
#include "study/report/figures/palette.h"
#include "study/report/figures/rows_canvas.h"
#include "study/report/figures/svg_canvas.h"
#include "study/report/study_parts.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

constexpr RowMeasures kSiteRows{.names = 190.0, .texts = 190.0, .height = 24.0};
constexpr double kLargestSquare = 18.0;  ///< side at a weight of 1

template <typename Do>
void forEachComparison(const FamilyResult& family, Do each) {
  for (const auto& cohort : family.cohorts) {
    if (!cohort.sites || !hasAnswers(cohort)) continue;
    for (const auto& row : cohort.sites->rows) each(cohort, row);
  }
}

/// A scale that covers all differences, the pooled intervals, and zero. The intervals of single
/// sites are cut off at the width of the answers' scale; with two participants at a site they are
/// often wider.
AxisScale siteScale(const FamilyResult& family) {
  double most = 0.0;
  double widest = 0.0;
  forEachComparison(family, [&](const auto& cohort, const auto& row) {
    widest = std::max(widest, cohort.table.highest - cohort.table.lowest);
    for (const auto& site : row.sites) {
      most = std::max(most, std::abs(site.test.meanDifference.value_or(0.0)));
      if (site.interval) most = std::max({most, -site.interval->low, site.interval->high});
    }
    if (!row.pooled) return;
    const auto& interval = row.pooled->knappHartung.interval;
    most = std::max({most, -interval.low, interval.high});
  });
  most = most > 0.0 ? 1.05 * std::min(most, widest) : 1.0;
  return {{.title = {}, .least = -most, .most = most}, -most, most};
}

class SitePainter {
 public:
  SitePainter(
      QPainter& painter,
      const ReportSection& section,
      const FamilyResult& family,
      const FigureFormat& format)
      : painter_(painter),
        section_(section),
        family_(family),
        canvas_(painter, format, kSiteRows, siteScale(family)) {}

  /// @param bottom  of the rows, where the axis is
  void paint(double bottom) {
    canvas_.axis(
        RowsCanvas::kHeading,
        bottom,
        section_.words.say(
            "difference of participants’ means [{}]", unitInWords(section_, family_.family)));
    forEachComparison(family_, [&](const auto& cohort, const auto& row) {
      canvas_.heading(
          section_.cohortTitle(cohort.cohort) + ": " + section_.conditionTitle(row.group1) + " − " +
          section_.conditionTitle(row.group2));
      canvas_.reference(0.0, canvas_.y(), canvas_.y() + canvas_.heightOf(row.sites.size() + 1));
      for (const auto& one : row.sites) {
        paintSite(one);
        canvas_.nextRow();
      }
      paintPooled(row);
      canvas_.nextRow();
    });
  }

 private:
  double clampedToPlot(double x) const { return std::clamp(x, canvas_.left(), canvas_.right()); }

  void paintSite(const analysis::SiteDifference& one) {
    canvas_.name(one.site + " (n = " + std::to_string(one.test.n) + ")");
    if (!one.test.meanDifference) {
      canvas_.words(section_.words("not defined"));
      return;
    }
    const QColor colour = categoryColour(0);
    if (one.interval) paintInterval(*one.interval, colour);
    const double half = 0.5 * std::max(3.0, kLargestSquare * std::sqrt(one.weight));
    painter_.setPen(QPen(Qt::white, 1));
    painter_.setBrush(colour);
    const double x = canvas_.x(*one.test.meanDifference);
    painter_.drawRect(QRectF(x - half, canvas_.middle() - half, 2.0 * half, 2.0 * half));
    auto words = rounded(one.test.meanDifference, 2) + " " + formatInterval(one.interval);
    if (one.weight > 0.0) words += "  " + rounded(100.0 * one.weight, 0) + " %";
    canvas_.words(words);
  }

  /// The line from end to end; an arrow where an end is beyond the axis.
  void paintInterval(const analysis::Interval& interval, const QColor& colour) {
    const double low = clampedToPlot(canvas_.x(interval.low));
    const double high = clampedToPlot(canvas_.x(interval.high));
    painter_.setPen(QPen(colour, 1.8, Qt::SolidLine, Qt::FlatCap));
    const double y = canvas_.middle();
    painter_.drawLine(QPointF(low, y), QPointF(high, y));
    if (low <= canvas_.left()) paintArrow(low, 1.0);
    if (high >= canvas_.right()) paintArrow(high, -1.0);
  }

  void paintArrow(double tip, double direction) {
    const QPointF at(tip, canvas_.middle());
    for (const double side : {-4.0, 4.0}) {
      painter_.drawLine(at, at + QPointF(direction * 6.0, side));
    }
  }

  void paintPooled(const analysis::SiteComparison& row) {
    canvas_.name(section_.words("All sites"));
    if (!row.pooled) {
      canvas_.words(section_.words("not defined"));
      return;
    }
    const auto& all = row.pooled->knappHartung;
    constexpr double kHalf = 7.0;
    const double y = canvas_.middle();
    QPolygonF diamond;
    diamond << QPointF(clampedToPlot(canvas_.x(all.interval.low)), y)
            << QPointF(canvas_.x(all.estimate), y - kHalf)
            << QPointF(clampedToPlot(canvas_.x(all.interval.high)), y)
            << QPointF(canvas_.x(all.estimate), y + kHalf);
    painter_.setPen(QPen(Qt::black, 1));
    painter_.setBrush(categoryColour(1));
    painter_.drawPolygon(diamond);
    canvas_.words(
        rounded(all.estimate, 2) + " " + formatInterval(all.interval) +
        "  I² = " + rounded(100.0 * row.pooled->reml.iSquared, 0) + " %");
  }

  QPainter& painter_;
  const ReportSection& section_;
  const FamilyResult& family_;
  RowsCanvas canvas_;
};

}  // namespace

std::string siteFigure(
    const ReportSection& section, const FamilyResult& family, const FigureFormat& format) {
  double bottom = 0.0;
  forEachComparison(family, [&](const auto&, const auto& row) {
    bottom += RowsCanvas::blockHeight(format, row.sites.size() + 1, kSiteRows);
  });
  if (bottom == 0.0) return {};
  return asSvg(
      {format.layoutWidth(), bottom + RowsCanvas::kAxis},
      [&](QPainter& painter) { SitePainter(painter, section, family, format).paint(bottom); },
      format);
}

}  // namespace study::report
