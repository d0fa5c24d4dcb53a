#include <algorithm>

#include "study/report/figures/figures.h"
#include "study/report/figures/palette.h"
#include "study/report/figures/rows_canvas.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

constexpr RowMeasures kPositionRows{.names = 190.0, .texts = 180.0, .height = 20.0};

}  // namespace

QSizeF positionFigureSize(const FamilyResult& family, const FigureFormat& format) {
  double height = RowsCanvas::kAxis;
  for (const auto& cohort : family.cohorts) {
    height += RowsCanvas::kHeading + static_cast<double>(cohort.position.positions.size()) *
                                         RowsCanvas::rowHeight(format, kPositionRows.height);
  }
  return {format.layoutWidth(), height};
}

void paintPositionFigure(
    QPainter& painter,
    const ReportSection& section,
    const FamilyResult& family,
    const FigureFormat& format) {
  const auto& table = family.cohorts.front().table;
  const double low = table.lowest;
  const double high = table.highest;
  RowsCanvas canvas(
      painter,
      format,
      kPositionRows,
      AxisScale({.title = {}, .least = low - 0.1, .most = high + 0.1}, low, high));
  const double bottom = positionFigureSize(family, format).height() - RowsCanvas::kAxis;
  canvas.axis(
      RowsCanvas::kHeading, bottom, section.words("mean score, all methods alike [points]"));
  double y = 0.0;
  for (const auto& cohort : family.cohorts) {
    canvas.heading(section.cohortTitle(cohort.cohort), y);
    y += RowsCanvas::kHeading;
    for (const auto& position : cohort.position.positions) {
      canvas.name(
          section.words.say("position {} (n = {})", position.position, position.participants),
          y,
          kPositionRows.height);
      const QColor colour = categoryColour(0);
      const double middle = canvas.drawingOf(y) + kPositionRows.height / 2;
      if (const auto& interval = position.interval) {
        canvas.interval(
            std::max(interval->low, low - 0.1),
            std::min(interval->high, high + 0.1),
            middle,
            colour,
            1.8);
      }
      canvas.dot(position.mean, middle, colour, 5.0);
      canvas.words(
          rounded(position.mean, 2) + " " + formatInterval(position.interval),
          y,
          kPositionRows.height);
      y += RowsCanvas::rowHeight(format, kPositionRows.height);
    }
  }
}

}  // namespace study::report
