#include <algorithm>
#include <cmath>
#include <map>

#include "study/report/figures/figures.h"
#include "study/report/figures/palette.h"
#include "study/report/figures/rows_canvas.h"
#include "study/report/figures/svg_canvas.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

constexpr RowMeasures kParticipantMeansRows{.names = 190.0, .texts = 122.0, .height = 24.0};
constexpr double kBox = 16.0;
constexpr double kDot = 2.8;
constexpr std::size_t kMostDots = 50;     // of more people the box is enough
constexpr std::size_t kFewestBoxed = 10;  // of fewer people a box hides more than it says
constexpr double kMargin = 0.075;         // beside the scale, as a share of its width

std::vector<double> valuesOf(const analysis::AnswerTable& table, std::size_t method) {
  std::vector<double> values;
  for (const auto& row : table.participantMeans()) {
    if (row[method]) values.push_back(*row[method]);
  }
  std::sort(values.begin(), values.end());
  return values;
}

double meanOf(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// A quantile, interpolated between the sorted values as R does by default (type 7).
double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

class ParticipantMeansPainter {
 public:
  ParticipantMeansPainter(
      QPainter& painter,
      const ReportSection& section,
      const FamilyResult& family,
      const FigureFormat& format)
      : painter_(painter),
        section_(section),
        family_(family),
        lowest_(family.cohorts.front().table.lowest),
        highest_(family.cohorts.front().table.highest),
        canvas_(
            painter,
            format,
            kParticipantMeansRows,
            AxisScale(
                {.title = {},
                 .least = lowest_ - kMargin * (highest_ - lowest_),
                 .most = highest_ + kMargin * (highest_ - lowest_)},
                lowest_,
                highest_)) {}

  /// @param bottom  of the rows, where the axis is
  void paint(double bottom) {
    canvas_.axis(
        RowsCanvas::kHeading,
        bottom,
        section_.words.say(
            "mean score of each participant [{}]", unitInWords(section_, family_.family)));
    for (const auto& cohort : family_.cohorts) {
      canvas_.heading(section_.cohortTitle(cohort.cohort));
      for (std::size_t method = 0; method < cohort.table.methods.size(); ++method) {
        row(cohort.table, method);
        canvas_.nextRow();
      }
    }
  }

 private:
  void row(const analysis::AnswerTable& table, std::size_t method) {
    canvas_.name(section_.conditionTitle(table.methods[method]));
    const auto values = valuesOf(table, method);
    const std::string number = "n = " + std::to_string(values.size());
    canvas_.words(values.empty() ? number : number + ", M = " + rounded(meanOf(values), 2));
    if (values.empty()) return;
    const QColor colour = categoryColour(section_.conditionIndex(table.methods[method]));
    box(values, canvas_.middle(), colour);
    if (values.size() <= kMostDots) dots(values, canvas_.middle(), colour);
  }

  void box(const std::vector<double>& values, double middle, const QColor& colour) {
    const double low = canvas_.x(quantile(values, 0.25));
    const double high = canvas_.x(quantile(values, 0.75));
    painter_.setPen(QPen(colour, 1.4));
    painter_.setBrush(Qt::white);
    const bool isBoxed = values.size() >= kFewestBoxed;
    if (isBoxed) painter_.drawRect(QRectF(low, middle - kBox / 2, high - low, kBox));
    const double mean = canvas_.x(meanOf(values));
    painter_.setPen(QPen(Qt::black, 1.2));
    painter_.drawPolygon(QPolygonF(
        {{mean, middle - 7}, {mean + 6, middle}, {mean, middle + 7}, {mean - 6, middle}}));
    const double median = canvas_.x(quantile(values, 0.5));
    painter_.setPen(QPen(colour, 2.6, Qt::SolidLine, Qt::FlatCap));
    painter_.drawLine(QPointF(median, middle - kBox / 2), QPointF(median, middle + kBox / 2));
  }

  /// Dots that would overlap are placed above each other around @p middle, closer together if there
  /// are many.
  void dots(const std::vector<double>& values, double middle, const QColor& colour) {
    std::map<int, std::vector<double>> columns;
    for (const double value : values) {
      columns[static_cast<int>(std::lround(canvas_.x(value) / (2.0 * kDot)))].push_back(value);
    }
    std::size_t highest = 1;
    for (const auto& [place, column] : columns) highest = std::max(highest, column.size());
    const double room = kParticipantMeansRows.height - 2.0 * kDot;
    const double step = std::min(2.0 * kDot, room / static_cast<double>(highest));
    for (const auto& [place, column] : columns) {
      double y = middle - 0.5 * step * static_cast<double>(column.size() - 1);
      for (const double value : column) {
        canvas_.dot(value, y, colour, kDot);
        y += step;
      }
    }
  }

  QPainter& painter_;
  const ReportSection& section_;
  const FamilyResult& family_;
  double lowest_;
  double highest_;
  RowsCanvas canvas_;
};

}  // namespace

std::string participantMeansFigure(
    const ReportSection& section, const FamilyResult& family, const FigureFormat& format) {
  double bottom = 0.0;
  for (const auto& cohort : family.cohorts) {
    bottom += RowsCanvas::blockHeight(format, cohort.table.methods.size(), kParticipantMeansRows);
  }
  return asSvg(
      {format.layoutWidth(), bottom + RowsCanvas::kAxis},
      [&](QPainter& painter) {
        ParticipantMeansPainter(painter, section, family, format).paint(bottom);
      },
      format);
}

}  // namespace study::report
