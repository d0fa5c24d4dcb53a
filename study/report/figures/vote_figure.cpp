#include "study/report/figures/figures.h"
#include "study/report/figures/palette.h"
#include "study/report/figures/rows_canvas.h"

namespace study::report {
namespace {

constexpr RowMeasures kVoteRows{.names = 210.0, .texts = 90.0, .height = 26.0};
constexpr double kVoteBar = 18.0;
constexpr double kVoteGap = 10.0;

class VotePainter {
 public:
  VotePainter(QPainter& painter, const ReportSection& section, const FigureFormat& format)
      : painter_(painter),
        section_(section),
        format_(format),
        canvas_(
            painter,
            format,
            kVoteRows,
            AxisScale({.title = {}, .least = 0.0, .most = 100.0}, 0.0, 100.0)) {}

  void paint() {
    const double bottom = voteFigureSize(section_, format_).height() - RowsCanvas::kAxis;
    canvas_.axis(
        RowsCanvas::kHeading,
        bottom,
        section_.words("share of the votes, with Wilson’s 95 % interval"),
        QStringLiteral(" %"));
    double y = 0.0;
    for (const auto& cohort : section_.results.flow) {
      for (const auto& vote : section_.results.votes) {
        if (vote.cohort == cohort.cohort) y = group(vote, y);
      }
    }
  }

 private:
  double group(const VoteResult& vote, double y) {
    canvas_.heading(section_.cohortTitle(vote.cohort) + ", " + vote.block, y);
    y += RowsCanvas::kHeading;
    const auto shares = vote.votes.shares();
    const double top = y;
    for (std::size_t i = 0; i < shares.size(); ++i) {
      row(shares[i].option, shares[i].votes, vote.votes.total(), vote, i, y);
      y += RowsCanvas::rowHeight(format_, kVoteRows.height);
    }
    if (!shares.empty()) {
      canvas_.reference(100.0 / static_cast<double>(shares.size()), top, y, Qt::DashLine);
    }
    return y + kVoteGap;
  }

  void row(
      const std::string& option,
      std::uint64_t votes,
      std::uint64_t total,
      const VoteResult& vote,
      std::size_t index,
      double y) {
    canvas_.name(section_.conditionTitle(option), y, kVoteRows.height);
    canvas_.words(std::to_string(votes) + " / " + std::to_string(total), y, kVoteRows.height);
    if (total == 0) return;
    y = canvas_.drawingOf(y);
    const double share = 100.0 * static_cast<double>(votes) / static_cast<double>(total);
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(categoryColour(section_.conditionPlace(option)));
    painter_.drawRect(QRectF(
        canvas_.x(0.0),
        y + (kVoteRows.height - kVoteBar) / 2,
        canvas_.x(share) - canvas_.x(0.0),
        kVoteBar));
    if (index >= vote.intervals.size() || !vote.intervals[index]) return;
    const auto& interval = *vote.intervals[index];
    canvas_.interval(
        100.0 * interval.low,
        100.0 * interval.high,
        y + kVoteRows.height / 2,
        QColor(40, 40, 40),
        1.6);
  }

  QPainter& painter_;
  const ReportSection& section_;
  FigureFormat format_;
  RowsCanvas canvas_;
};

}  // namespace

QSizeF voteFigureSize(const ReportSection& section, const FigureFormat& format) {
  double height = RowsCanvas::kAxis;
  for (const auto& vote : section.results.votes) {
    height += RowsCanvas::kHeading +
              static_cast<double>(vote.votes.shares().size()) *
                  RowsCanvas::rowHeight(format, kVoteRows.height) +
              kVoteGap;
  }
  return {format.layoutWidth(), height};
}

void paintVoteFigure(QPainter& painter, const ReportSection& section, const FigureFormat& format) {
  VotePainter(painter, section, format).paint();
}

}  // namespace study::report
