#include "study/report/vote_figure.h"

#include <algorithm>

#include "study/report/palette.h"
#include "study/report/svg_canvas.h"

namespace study::report {
namespace {

constexpr double kWidth = 820.0;
constexpr double kLabels = 330.0;
constexpr double kBar = 24.0;
constexpr double kGap = 10.0;
constexpr double kLegend = 34.0;

/// A colour for each condition of the protocol, whichever block it was voted on in.
int colourIndex(const ReportSection& section, const std::string& condition) {
  const auto& all = section.protocol.conditions;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& c) { return c.id == condition; });
  return static_cast<int>(found - all.begin());
}

void paintLegend(QPainter& painter, const ReportSection& section, double y) {
  std::vector<std::string> shown;
  for (const auto& vote : section.results.votes) {
    for (const auto& share : vote.votes.shares()) {
      if (std::find(shown.begin(), shown.end(), share.option) == shown.end())
        shown.push_back(share.option);
    }
  }
  const double room = kWidth / static_cast<double>(std::max<std::size_t>(shown.size(), 1));
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const double x = static_cast<double>(i) * room;
    painter.setPen(Qt::NoPen);
    painter.setBrush(categoryColour(colourIndex(section, shown[i])));
    painter.drawRect(QRectF(x, y + 8, 18, 14));
    painter.setPen(Qt::black);
    drawText(
        painter,
        {x + 26, y, room - 30, 30},
        Qt::AlignLeft | Qt::AlignVCenter,
        QString::fromStdString(section.conditionTitle(shown[i])),
        12);
  }
}

void paintBar(QPainter& painter, const ReportSection& section, const VoteResult& vote, double y) {
  painter.setPen(Qt::black);
  drawText(
      painter,
      {0, y, kLabels - 12, kBar},
      Qt::AlignRight | Qt::AlignVCenter,
      QString::fromStdString(section.cohortTitle(vote.cohort) + ", " + vote.block),
      12);
  const double unit =
      (kWidth - kLabels) / static_cast<double>(std::max<std::uint64_t>(vote.votes.total(), 1));
  double x = kLabels;
  for (const auto& share : vote.votes.shares()) {
    if (share.votes == 0) continue;
    const double wide = static_cast<double>(share.votes) * unit;
    painter.setPen(QPen(Qt::white, 1));
    painter.setBrush(categoryColour(colourIndex(section, share.option)));
    painter.drawRect(QRectF(x, y, wide, kBar));
    painter.setPen(Qt::white);
    drawText(painter, {x, y, wide, kBar}, Qt::AlignCenter, QString::number(share.votes), 12, true);
    x += wide;
  }
}

}  // namespace

QSizeF voteFigureSize(const ReportSection& section) {
  return {kWidth, kLegend + static_cast<double>(section.results.votes.size()) * (kBar + kGap)};
}

void paintVoteFigure(QPainter& painter, const ReportSection& section) {
  double y = 2.0;
  for (const auto& cohort : section.results.flow) {
    for (const auto& vote : section.results.votes) {
      if (vote.cohort != cohort.cohort) continue;
      paintBar(painter, section, vote, y);
      y += kBar + kGap;
    }
  }
  paintLegend(painter, section, y);
}

}  // namespace study::report
