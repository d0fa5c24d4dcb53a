#include <algorithm>
#include <cmath>

#include "study/report/figures/figures.h"
#include "study/report/figures/palette.h"
#include "study/report/figures/rows_canvas.h"
#include "study/report/figures/svg_canvas.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

constexpr RowMeasures kEffectRows{.names = 250.0, .texts = 180.0, .height = 16.0};

/// The interval at 1 − α/m, if p is corrected in the same way: by Bonferroni's method. Beside
/// another correction it may cover zero where p is below α.
std::optional<analysis::Interval> correctedInterval(
    const FamilyResult& family, const analysis::TestRow& test) {
  return family.family.correction == protocols::CorrectionType::Bonferroni ? test.adjustedInterval
                                                                           : std::nullopt;
}

/// A scale that covers all intervals, the equivalence bounds, and zero.
AxisScale effectScale(const FamilyResult& family) {
  double most = family.family.equivalenceBound.value_or(0.0);
  for (const auto& cohort : family.cohorts) {
    for (const auto& row : cohort.within.rows) {
      const auto& test = row.test("paired_t");
      for (const auto& interval : {test.interval, correctedInterval(family, test)}) {
        if (interval) most = std::max({most, -interval->low, interval->high});
      }
      most = std::max(most, std::abs(test.estimate.value.value_or(0.0)));
    }
  }
  most = most > 0.0 ? 1.05 * most : 1.0;
  return {{.title = {}, .least = -most, .most = most}, -most, most};
}

class EffectPainter {
 public:
  EffectPainter(
      QPainter& painter,
      const ReportSection& section,
      const FamilyResult& family,
      const FigureFormat& format)
      : painter_(painter),
        section_(section),
        family_(family),
        canvas_(painter, format, kEffectRows, effectScale(family)) {}

  /// @param bottom  of the rows, where the axis is
  void paint(double bottom) {
    const double top = RowsCanvas::kHeading;
    if (const auto bound = family_.family.equivalenceBound) {
      painter_.setPen(Qt::NoPen);
      painter_.setBrush(QColor(0xee, 0xee, 0xee));
      painter_.drawRect(
          QRectF(QPointF(canvas_.x(-*bound), top), QPointF(canvas_.x(*bound), bottom)));
    }
    canvas_.axis(
        top,
        bottom,
        section_.words.say(
            "difference of participants’ means [{}]", unitInWords(section_, family_.family)));
    canvas_.reference(0.0, top, bottom);
    for (const auto& cohort : family_.cohorts) {
      canvas_.heading(section_.cohortTitle(cohort.cohort));
      for (const auto& row : cohort.within.rows) {
        effect(row);
        canvas_.nextRow();
      }
    }
  }

 private:
  void effect(const analysis::WithinComparison& row) {
    canvas_.name(section_.conditionTitle(row.group1) + " − " + section_.conditionTitle(row.group2));
    const auto& test = row.test("paired_t");
    const auto difference = test.estimate.value;
    if (!difference) {
      canvas_.words(section_.words("not defined"));
      return;
    }
    const QColor colour = categoryColour(0);
    if (const auto wider = correctedInterval(family_, test)) {
      canvas_.interval(wider->low, wider->high, canvas_.middle(), colour, 1.4);
    }
    if (test.interval) {
      canvas_.interval(test.interval->low, test.interval->high, canvas_.middle(), colour, 4.0);
    }
    canvas_.dot(*difference, canvas_.middle(), colour, 5.5);
    canvas_.words(rounded(difference, 2) + " " + formatInterval(test.interval));
  }

  QPainter& painter_;
  const ReportSection& section_;
  const FamilyResult& family_;
  RowsCanvas canvas_;
};

}  // namespace

std::string effectFigure(
    const ReportSection& section, const FamilyResult& family, const FigureFormat& format) {
  double bottom = 0.0;
  for (const auto& cohort : family.cohorts) {
    bottom += RowsCanvas::blockHeight(format, cohort.within.rows.size(), kEffectRows);
  }
  return asSvg(
      {format.layoutWidth(), bottom + RowsCanvas::kAxis},
      [&](QPainter& painter) { EffectPainter(painter, section, family, format).paint(bottom); },
      format);
}

}  // namespace study::report
