#include "analysis/data/vote_shares.h"
#include "questionnaires/model/answer.h"
#include "study/report/figures/figures.h"
#include "study/report/figures/palette.h"
#include "study/report/figures/rows_canvas.h"
#include "study/report/figures/svg_canvas.h"

namespace study::report {
namespace {

constexpr RowMeasures kVoteRows{.names = 210.0, .texts = 90.0, .height = 17.0};
constexpr double kVoteBar = 12.0;
constexpr double kVoteGap = 6.0;

/// One bar.
struct Share {
  std::string name;
  std::uint64_t times = 0;
  std::optional<analysis::Interval> interval;
  int colour = 0;  ///< index for categoryColour()
};

/// Bars below a heading.
struct ShareGroup {
  std::string heading;
  std::uint64_t total = 0;
  std::vector<Share> bars;
  bool marksEqualShare = false;  ///< the share of each, if all were chosen equally often, is marked
};

std::vector<ShareGroup> sharesOf(const ReportSection& section) {
  std::vector<ShareGroup> all;
  for (const auto& cohort : section.results.flow) {
    for (const auto& vote : section.results.votes) {
      if (vote.cohort != cohort.cohort || vote.votes.total() == 0) continue;
      auto& group = all.emplace_back(ShareGroup{
          .heading = section.cohortTitle(vote.cohort) + ", " + section.blockTitle(vote.block),
          .total = vote.votes.total(),
          .marksEqualShare = true});
      const auto shares = vote.votes.shares();
      for (std::size_t i = 0; i < shares.size(); ++i) {
        group.bars.push_back(
            {.name = section.conditionTitle(shares[i].option),
             .times = shares[i].votes,
             .interval = i < vote.intervals.size() ? vote.intervals[i] : std::nullopt,
             .colour = section.conditionIndex(shares[i].option)});
      }
    }
  }
  return all;
}

/// A group for each cohort and alternative, a bar for each option.
std::vector<ShareGroup> sharesOf(
    const ReportSection& section,
    const questionnaires::Item& item,
    const std::vector<ItemSummary>& summaries) {
  std::vector<ShareGroup> all;
  for (const auto& one : summaries) {
    auto& group = all.emplace_back(ShareGroup{
        .heading = section.cohortTitle(one.cohort) + ", " + section.conditionTitle(one.condition),
        .total = one.answers});
    for (const auto& [id, times] : one.options) {
      const auto label = questionnaires::labelOf(item, id, section.words.language());
      group.bars.push_back(
          {.name = label.empty() ? id : label,
           .times = times,
           .interval = analysis::wilsonInterval(times, one.answers),
           .colour = section.conditionIndex(one.condition)});
    }
  }
  return all;
}

class SharePainter {
 public:
  SharePainter(QPainter& painter, const FigureFormat& format)
      : painter_(painter),
        canvas_(
            painter,
            format,
            kVoteRows,
            AxisScale({.title = {}, .least = 0.0, .most = 100.0}, 0.0, 100.0)) {}

  /// @param bottom  of the rows, where the axis is
  void paint(const std::vector<ShareGroup>& groups, const std::string& axis, double bottom) {
    canvas_.axis(RowsCanvas::kHeading, bottom, axis, QStringLiteral(" %"));
    for (const auto& group : groups) {
      canvas_.heading(group.heading);
      const double top = canvas_.y();
      for (const auto& share : group.bars) {
        bar(share, group.total);
        canvas_.nextRow();
      }
      if (group.marksEqualShare && !group.bars.empty()) {
        canvas_.reference(
            100.0 / static_cast<double>(group.bars.size()), top, canvas_.y(), Qt::DashLine);
      }
      canvas_.skip(kVoteGap);
    }
  }

 private:
  void bar(const Share& share, std::uint64_t total) {
    canvas_.name(share.name);
    canvas_.words(std::to_string(share.times) + " / " + std::to_string(total));
    if (total == 0) return;
    const double percent = 100.0 * static_cast<double>(share.times) / static_cast<double>(total);
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(categoryColour(share.colour));
    painter_.drawRect(QRectF(
        canvas_.x(0.0),
        canvas_.middle() - kVoteBar / 2,
        canvas_.x(percent) - canvas_.x(0.0),
        kVoteBar));
    if (!share.interval) return;
    canvas_.interval(
        100.0 * share.interval->low,
        100.0 * share.interval->high,
        canvas_.middle(),
        QColor(40, 40, 40),
        1.6);
  }

  QPainter& painter_;
  RowsCanvas canvas_;
};

/// @param axis  the title of the value axis
std::string shareFigure(
    const std::vector<ShareGroup>& groups, const std::string& axis, const FigureFormat& format) {
  double bottom = 0.0;
  for (const auto& group : groups) {
    bottom += RowsCanvas::blockHeight(format, group.bars.size(), kVoteRows) + kVoteGap;
  }
  return asSvg(
      {format.layoutWidth(), bottom + RowsCanvas::kAxis},
      [&](QPainter& painter) { SharePainter(painter, format).paint(groups, axis, bottom); },
      format);
}

}  // namespace

std::string voteFigure(const ReportSection& section, const FigureFormat& format) {
  return shareFigure(
      sharesOf(section), section.words("share of the votes, with Wilson’s 95 % interval"), format);
}

std::string choiceFigure(
    const ReportSection& section,
    const questionnaires::Item& item,
    const std::vector<ItemSummary>& summaries,
    const FigureFormat& format) {
  return shareFigure(
      sharesOf(section, item, summaries),
      section.words("share of the answers, with Wilson’s 95 % interval"),
      format);
}

}  // namespace study::report
