#include <algorithm>
#include <cmath>
#include <map>

#include <QPainterPath>

#include "study/report/figures/figures.h"
#include "study/report/figures/palette.h"
#include "study/report/figures/rows_canvas.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

constexpr RowMeasures kCloudRows{.names = 190.0, .texts = 110.0, .height = 84.0};
constexpr double kCloud = 34.0;  // of a row, from its top
constexpr RowMeasures kDryRows{.names = 190.0, .texts = 110.0, .height = 52.0};
constexpr RowMeasures kRainRows{.names = 190.0, .texts = 110.0, .height = 54.0};
constexpr double kNoCloud = 4.0;
constexpr double kBox = 9.0;
constexpr double kDot = 3.6;
constexpr std::size_t kMostDots = 9;  // of more people a box says enough, and names nobody
constexpr double kMargin = 0.075;     // beside the scale, as a share of its width
constexpr double kLeastWidth = 0.02;  // of a density, as a share of the scale's width

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

/// Silverman's rule of thumb, 0.9 min(s, IQR / 1.34) n^(−1/5) [points], and at least @p least, so
/// that equal values have a density, too.
double bandwidthOf(const std::vector<double>& sorted, double least) {
  const double mean = meanOf(sorted);
  double squares = 0.0;
  for (const double value : sorted) squares += (value - mean) * (value - mean);
  const auto n = static_cast<double>(sorted.size());
  const double deviation = std::sqrt(squares / std::max(n - 1.0, 1.0));
  const double middleHalf = (quantile(sorted, 0.75) - quantile(sorted, 0.25)) / 1.34;
  const double spread = middleHalf > 0.0 ? std::min(deviation, middleHalf) : deviation;
  return std::max(0.9 * spread * std::pow(n, -0.2), least);
}

const RowMeasures& rowsOf(const FamilyResult& family, Clouds clouds) {
  if (clouds == Clouds::Hidden) return kRainRows;
  for (const auto& cohort : family.cohorts) {
    for (std::size_t method = 0; method < cohort.table.methods.size(); ++method) {
      if (valuesOf(cohort.table, method).size() <= kMostDots) return kCloudRows;
    }
  }
  return kDryRows;
}

class RaincloudPainter {
 public:
  RaincloudPainter(
      QPainter& painter,
      const ReportSection& section,
      const FamilyResult& family,
      const FigureFormat& format,
      Clouds clouds)
      : painter_(painter),
        section_(section),
        family_(family),
        format_(format),
        clouds_(clouds),
        rows_(rowsOf(family, clouds)),
        cloud_(clouds == Clouds::Shown ? kCloud : kNoCloud),
        lowest_(family.cohorts.front().table.lowest),
        highest_(family.cohorts.front().table.highest),
        canvas_(
            painter,
            format,
            rows_,
            AxisScale(
                {.title = {},
                 .least = lowest_ - kMargin * (highest_ - lowest_),
                 .most = highest_ + kMargin * (highest_ - lowest_)},
                lowest_,
                highest_)) {}

  void paint() {
    const double bottom =
        raincloudFigureSize(family_, format_, clouds_).height() - RowsCanvas::kAxis;
    canvas_.axis(
        RowsCanvas::kHeading, bottom, section_.words("mean score of each participant [points]"));
    double y = 0.0;
    for (const auto& cohort : family_.cohorts) {
      canvas_.heading(section_.cohortTitle(cohort.cohort), y);
      y += RowsCanvas::kHeading;
      for (std::size_t method = 0; method < cohort.table.methods.size(); ++method) {
        row(cohort.table, method, y);
        y += RowsCanvas::rowHeight(format_, rows_.height);
      }
    }
  }

 private:
  void row(const analysis::AnswerTable& table, std::size_t method, double y) {
    canvas_.name(section_.conditionTitle(table.methods[method]), y, rows_.height);
    const auto values = valuesOf(table, method);
    const std::string number = "n = " + std::to_string(values.size());
    if (values.empty()) return canvas_.words(number, y, rows_.height / 2);
    const std::string mean = "M = " + rounded(meanOf(values), 2);
    if (canvas_.isNarrow()) {
      canvas_.words(mean + ", " + number, y, rows_.height / 2);
    } else {
      canvas_.words(number, y, rows_.height / 2);
      canvas_.words(mean, y + rows_.height / 2 - 12, rows_.height / 2);
    }
    y = canvas_.drawingOf(y);
    const QColor colour = categoryColour(section_.conditionPlace(table.methods[method]));
    if (values.size() > 2 && clouds_ == Clouds::Shown) cloud(values, y + cloud_, colour);
    box(values, y + cloud_ + 4 + kBox / 2, colour);
    if (values.size() <= kMostDots) rain(values, y + cloud_ + kBox + 10, colour);
  }

  /// The density within the scale's ends, scaled to the height of its row.
  void cloud(const std::vector<double>& values, double ground, QColor colour) {
    const double width = bandwidthOf(values, kLeastWidth * (highest_ - lowest_));
    std::vector<QPointF> points;
    double most = 0.0;
    constexpr int kSteps = 160;
    for (int i = 0; i <= kSteps; ++i) {
      const double at = lowest_ + (highest_ - lowest_) * static_cast<double>(i) / kSteps;
      double density = 0.0;
      for (const double value : values)
        density += std::exp(-0.5 * std::pow((at - value) / width, 2));
      most = std::max(most, density);
      points.emplace_back(at, density);
    }
    QPainterPath path(QPointF(canvas_.x(lowest_), ground));
    for (const auto& point : points) {
      path.lineTo(canvas_.x(point.x()), ground - (kCloud - 6) * point.y() / most);
    }
    path.lineTo(canvas_.x(highest_), ground);
    path.closeSubpath();
    painter_.setPen(QPen(colour, 1.2));
    colour.setAlphaF(0.28F);
    painter_.setBrush(colour);
    painter_.drawPath(path);
  }

  void box(const std::vector<double>& values, double middle, const QColor& colour) {
    const double low = canvas_.x(quantile(values, 0.25));
    const double high = canvas_.x(quantile(values, 0.75));
    painter_.setPen(QPen(colour, 1.4));
    painter_.setBrush(Qt::white);
    painter_.drawRect(QRectF(low, middle - kBox / 2, high - low, kBox));
    const double median = canvas_.x(quantile(values, 0.5));
    painter_.setPen(QPen(colour, 2.6));
    painter_.drawLine(QPointF(median, middle - kBox / 2), QPointF(median, middle + kBox / 2));
    const double mean = canvas_.x(meanOf(values));
    painter_.setPen(QPen(Qt::white, 0.8));
    painter_.setBrush(Qt::black);
    painter_.drawPolygon(QPolygonF(
        {{mean, middle - 6}, {mean + 5, middle}, {mean, middle + 6}, {mean - 5, middle}}));
  }

  /// Dots that would overlap are placed below each other, closer together if there are many.
  void rain(const std::vector<double>& values, double top, const QColor& colour) {
    std::map<int, std::vector<double>> columns;
    for (const double value : values) {
      columns[static_cast<int>(std::lround(canvas_.x(value) / (2.0 * kDot)))].push_back(value);
    }
    std::size_t highest = 1;
    for (const auto& [place, column] : columns) highest = std::max(highest, column.size());
    const double room = rows_.height - (cloud_ + kBox + 10) - kDot;
    const double step = std::min(2.0 * kDot, room / static_cast<double>(highest));
    for (const auto& [place, column] : columns) {
      double y = top;
      for (const double value : column) {
        canvas_.dot(value, y, colour, kDot);
        y += step;
      }
    }
  }

  QPainter& painter_;
  const ReportSection& section_;
  const FamilyResult& family_;
  FigureFormat format_;
  Clouds clouds_;
  RowMeasures rows_;
  double cloud_;  ///< height, of a row from its top
  double lowest_;
  double highest_;
  RowsCanvas canvas_;
};

}  // namespace

QSizeF raincloudFigureSize(const FamilyResult& family, const FigureFormat& format, Clouds clouds) {
  double height = RowsCanvas::kAxis;
  for (const auto& cohort : family.cohorts) {
    height +=
        RowsCanvas::kHeading + static_cast<double>(cohort.table.methods.size()) *
                                   RowsCanvas::rowHeight(format, rowsOf(family, clouds).height);
  }
  return {format.layoutWidth(), height};
}

void paintRaincloudFigure(
    QPainter& painter,
    const ReportSection& section,
    const FamilyResult& family,
    const FigureFormat& format,
    Clouds clouds) {
  RaincloudPainter(painter, section, family, format, clouds).paint();
}

}  // namespace study::report
