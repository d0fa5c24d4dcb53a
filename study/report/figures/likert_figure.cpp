#include <algorithm>

#include "study/report/figures/figures.h"
#include "study/report/figures/palette.h"
#include "study/report/figures/svg_canvas.h"

namespace study::report {
namespace {

constexpr double kNamesWidth = 210.0;    // width of the names on the left
constexpr double kNumbersWidth = 112.0;  // … and of the numbers on the right
constexpr double kBar = 20.0;
constexpr double kGap = 6.0;
constexpr double kHeading = 24.0;
constexpr double kLegend = 42.0;
constexpr double kNameLine = 18.0;  // above a bar of a narrow figure

double rowHeight(bool isNarrow) {
  return kBar + kGap + (isNarrow ? kNameLine : 0.0);
}

/// The share of a bar to the left of the middle line: the points below the middle of the scale, and
/// half of the middle point if there is one.
double leftShare(const std::vector<double>& shares) {
  const std::size_t n = shares.size();
  double left = 0.0;
  for (std::size_t i = 0; i < n / 2; ++i) left += shares[i];
  return n % 2 == 1 ? left + shares[n / 2] / 2.0 : left;
}

std::vector<double> sharesOf(const analysis::LikertCounts& counts) {
  std::vector<double> shares;
  for (const auto count : counts.counts()) {
    shares.push_back(
        counts.total() == 0 ? 0.0
                            : static_cast<double>(count) / static_cast<double>(counts.total()));
  }
  return shares;
}

/// Paints one figure: a panel for each cohort, a bar for each condition.
class LikertPainter {
 public:
  LikertPainter(
      QPainter& painter,
      const ReportSection& section,
      const FamilyResult& family,
      const FigureFormat& format)
      : painter_(painter),
        section_(section),
        family_(family),
        isNarrow_(format.isNarrow()),
        width_(format.layoutWidth()),
        labels_(isNarrow_ ? 0.0 : kNamesWidth),
        rightWidth_(isNarrow_ ? 0.0 : kNumbersWidth) {
    for (const auto& cohort : family.cohorts) {
      for (const auto& condition : cohort.conditions) {
        const auto shares = sharesOf(*condition.answers.points());
        largestLeftShare_ = std::max(largestLeftShare_, leftShare(shares));
        largestRightShare_ = std::max(largestRightShare_, 1.0 - leftShare(shares));
      }
    }
    unit_ =
        (width_ - labels_ - rightWidth_) / std::max(largestLeftShare_ + largestRightShare_, 0.5);
  }

  void paint() {
    double y = 4.0;
    for (const auto& cohort : family_.cohorts) {
      painter_.setPen(Qt::black);
      drawText(
          painter_,
          {0, y, width_, kHeading},
          Qt::AlignLeft | Qt::AlignVCenter,
          QString::fromStdString(section_.cohortTitle(cohort.cohort)),
          true);
      y += kHeading;
      for (const auto& condition : cohort.conditions) {
        bar(condition, y);
        y += rowHeight(isNarrow_);
      }
      y += kGap;
    }
    legend(y);
  }

 private:
  double middle() const { return labels_ + largestLeftShare_ * unit_; }

  void bar(const analysis::NamedSample& condition, double y) {
    painter_.setPen(Qt::black);
    drawText(
        painter_,
        isNarrow_ ? QRectF(0, y, width_, kNameLine) : QRectF(0, y, kNamesWidth - 12, kBar),
        (isNarrow_ ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter,
        QString::fromStdString(section_.conditionTitle(condition.name)));
    const double nameAt = y;
    if (isNarrow_) y += kNameLine;
    painter_.setPen(QPen(QColor(60, 60, 60), 1));
    painter_.drawLine(QPointF(middle(), y - 3), QPointF(middle(), y + kBar + 3));
    const auto shares = sharesOf(*condition.answers.points());
    double x = middle() - leftShare(shares) * unit_;
    for (std::size_t i = 0; i < shares.size(); ++i) {
      const double wide = shares[i] * unit_;
      segment(
          {x, y, wide, kBar},
          static_cast<int>(i),
          static_cast<int>(shares.size()),
          condition.answers.points()->counts()[i]);
      x += wide;
    }
    painter_.setPen(Qt::black);
    drawText(
        painter_,
        isNarrow_ ? QRectF(0, nameAt, width_, kNameLine)
                  : QRectF(width_ - kNumbersWidth + 10, y, kNumbersWidth - 10, kBar),
        (isNarrow_ ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter,
        QString::fromStdString(
            "n = " + std::to_string(condition.answers.total()) +
            ", M = " + rounded(condition.answers.mean(), 2)));
  }

  void segment(const QRectF& where, int index, int points, std::uint64_t count) {
    if (count == 0) return;
    const QColor colour = divergingColour(index, points);
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(colour);
    painter_.drawRect(where);
    constexpr double kDigit = 7.5;  // width
    if (where.width() < kDigit * static_cast<double>(std::to_string(count).size()) + 1.0) return;
    painter_.setPen(colour.lightnessF() < 0.5 ? Qt::white : Qt::black);
    drawText(painter_, where, Qt::AlignCenter, QString::number(count));
  }

  void legend(double y) {
    const auto& counts = family_.cohorts.front().conditions.front().answers.points().value();
    const auto* instrument = section_.instrument(family_.family.instrument);
    const int points = counts.highest() - counts.lowest() + 1;
    const double box = isNarrow_ ? width_ / points : 34.0;
    double x = labels_;
    for (int i = 0; i < points; ++i) {
      painter_.setPen(Qt::NoPen);
      painter_.setBrush(divergingColour(i, points));
      painter_.drawRect(QRectF(x, y + 6, box, 14));
      painter_.setPen(Qt::black);
      drawText(
          painter_,
          {x, y + 21, box, 16},
          Qt::AlignCenter,
          QString::number(counts.lowest() + i).replace(u'-', u'−'));
      x += box;
    }
    if (instrument == nullptr || !instrument->scale) return;
    painter_.setPen(Qt::black);
    drawText(
        painter_,
        isNarrow_ ? QRectF(0, y + 37, width_ / 2, 20) : QRectF(0, y + 3, kNamesWidth - 12, 20),
        (isNarrow_ ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter,
        QString::fromStdString(instrument->scale->lowLabel.in(section_.words.language())));
    drawText(
        painter_,
        isNarrow_ ? QRectF(width_ / 2, y + 37, width_ / 2, 20)
                  : QRectF(x + 12, y + 3, width_ - x - 12, 20),
        (isNarrow_ ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter,
        QString::fromStdString(instrument->scale->highLabel.in(section_.words.language())));
  }

  QPainter& painter_;
  const ReportSection& section_;
  const FamilyResult& family_;
  bool isNarrow_;
  double width_;
  double labels_;
  double rightWidth_;
  double largestLeftShare_ = 0.0;
  double largestRightShare_ = 0.0;
  double unit_ = 1.0;
};

}  // namespace

std::string likertFigure(
    const ReportSection& section, const FamilyResult& family, const FigureFormat& format) {
  double height = kLegend + (format.isNarrow() ? kNameLine : 0.0);
  for (const auto& cohort : family.cohorts) {
    height += kHeading + kGap +
              static_cast<double>(cohort.conditions.size()) * rowHeight(format.isNarrow());
  }
  return asSvg(
      {format.layoutWidth(), height},
      [&](QPainter& painter) { LikertPainter(painter, section, family, format).paint(); },
      format);
}

}  // namespace study::report
