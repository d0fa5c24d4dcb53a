#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "study/report/figures/figures.h"
#include "study/report/figures/svg_canvas.h"
#include "study/report/study_parts.h"

namespace study::report {
namespace {

constexpr double kFlowBox = 28.0;    // height
constexpr double kFlowLine = 18.0;   // of text outside boxes
constexpr double kFlowSpace = 8.0;   // below a row
constexpr double kFlowName = 200.0;  // width, in a wide figure

/// Participants of one cohort or site, from enrolment to the comparison.
struct FlowRow {
  std::string name;
  std::vector<std::string> boxes;
  std::string lost;  ///< between the first two boxes; empty if all completed
};

/// The number of participants whose answers are compared; std::nullopt if nothing is compared.
std::optional<std::size_t> analysedOf(const ReportSection& section, const std::string& cohort) {
  const auto* family = mainFamily(section);
  if (family == nullptr) return std::nullopt;
  for (const auto& part : family->cohorts) {
    if (part.cohort == cohort) return hasAnswers(part) ? part.table.participants.size() : 0;
  }
  return std::nullopt;
}

FlowRow rowOf(
    const words::Words& words,
    const std::string& name,
    const CohortFlow& flow,
    std::optional<std::size_t> analysed) {
  const auto box = [&](std::string_view what, std::size_t people) {
    return words(what) + ": " + std::to_string(people);
  };
  FlowRow row{
      .name = name,
      .boxes =
          {box("Enrolled", static_cast<std::size_t>(flow.enrolled)),
           box("Completed", static_cast<std::size_t>(flow.completed))},
      .lost = {}};
  if (analysed) row.boxes.push_back(box("Analysed", *analysed));
  for (const auto& [what, people] : std::array{
           std::pair{"In progress", flow.inProgress},
           std::pair{"Declined", flow.declined},
           std::pair{"Withdrawn", flow.withdrawn},
           std::pair{"Rejected", flow.rejected},
           std::pair{"Device failed", flow.abortedHardware},
           std::pair{"Erased", flow.erased}}) {
    if (people == 0) continue;
    row.lost += (row.lost.empty() ? "" : ", ") + box(what, static_cast<std::size_t>(people));
  }
  return row;
}

std::vector<FlowRow> rowsOf(const ReportSection& section) {
  std::vector<FlowRow> rows;
  const bool isAnyEnrolled =
      std::ranges::any_of(section.results.flow, [](const auto& flow) { return flow.enrolled > 0; });
  for (const auto& flow : section.results.flow) {
    if (isAnyEnrolled && flow.enrolled == 0) continue;
    rows.push_back(rowOf(
        section.words, section.cohortTitle(flow.cohort), flow, analysedOf(section, flow.cohort)));
  }
  for (const auto& [site, flow] : section.results.siteFlow) {
    rows.push_back(rowOf(section.words, section.words.say("Site {}", site), flow, std::nullopt));
  }
  return rows;
}

double heightOf(const FlowRow& row, const FigureFormat& format) {
  return (format.isNarrow() ? kFlowLine : 0.0) + kFlowBox + (row.lost.empty() ? 0.0 : kFlowLine) +
         kFlowSpace;
}

class FlowPainter {
 public:
  FlowPainter(QPainter& painter, const FigureFormat& format)
      : painter_(painter),
        isNarrow_(format.isNarrow()),
        left_(isNarrow_ ? 1.0 : kFlowName),
        width_(format.layoutWidth() - 1.0) {}

  void paint(const FlowRow& row, double y) {
    constexpr double kMost = 3.0;  // boxes
    const double box = (width_ - left_) / (kMost + (kMost - 1.0) * kGap);
    const double step = box * (1.0 + kGap);
    painter_.setPen(Qt::black);
    words(
        isNarrow_ ? QRectF(0.0, y, width_, kFlowLine) : QRectF(0.0, y, kFlowName - 14.0, kFlowBox),
        row.name,
        isNarrow_ ? Qt::AlignLeft : Qt::AlignRight);
    if (isNarrow_) y += kFlowLine;
    for (std::size_t i = 0; i < row.boxes.size(); ++i) {
      const QRectF where(left_ + static_cast<double>(i) * step, y + 1.0, box, kFlowBox - 2.0);
      painter_.setPen(QPen(QColor(70, 70, 70), 1.2));
      painter_.setBrush(QColor(242, 245, 248));
      painter_.drawRect(where);
      words(where, row.boxes[i], Qt::AlignHCenter);
      if (i > 0) arrow(where.left() - box * kGap, where.left(), where.center().y());
    }
    if (row.lost.empty()) return;
    const double middle = left_ + box + box * kGap / 2.0;
    painter_.drawLine(
        QPointF(middle, y + kFlowBox / 2.0), QPointF(middle, y + kFlowBox + kFlowLine / 2.0));
    words(
        QRectF(middle + 6.0, y + kFlowBox, width_ - middle - 6.0, kFlowLine),
        row.lost,
        Qt::AlignLeft);
  }

 private:
  static constexpr double kGap = 0.25;  ///< between boxes, of a box

  void words(const QRectF& where, const std::string& text, Qt::AlignmentFlag side) {
    painter_.setPen(Qt::black);
    drawText(
        painter_, where, side | Qt::AlignVCenter | Qt::TextWordWrap, QString::fromStdString(text));
  }

  void arrow(double from, double to, double y) {
    painter_.setPen(QPen(QColor(70, 70, 70), 1.2));
    painter_.drawLine(QPointF(from, y), QPointF(to, y));
    for (const double side : {-4.0, 4.0}) {
      painter_.drawLine(QPointF(to - 6.0, y + side), QPointF(to, y));
    }
  }

  QPainter& painter_;
  bool isNarrow_;
  double left_;
  double width_;
};

}  // namespace

QSizeF flowFigureSize(const ReportSection& section, const FigureFormat& format) {
  double height = 0.0;
  for (const auto& row : rowsOf(section)) height += heightOf(row, format);
  return {format.layoutWidth(), height};
}

void paintFlowFigure(QPainter& painter, const ReportSection& section, const FigureFormat& format) {
  double y = 0.0;
  for (const auto& row : rowsOf(section)) {
    FlowPainter(painter, format).paint(row, y);
    y += heightOf(row, format);
  }
}

}  // namespace study::report
