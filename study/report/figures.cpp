#include "study/report/figures.h"

#include <algorithm>

#include "study/report/felt_figure.h"
#include "study/report/likert_figure.h"
#include "study/report/svg_canvas.h"
#include "study/report/vote_figure.h"

namespace study::report {

void paintFigures(ReportSection& section) {
  section.figures = {};
  for (const auto& family : section.results.families) {
    section.figures.likert.push_back(asSvg(likertFigureSize(family), [&](QPainter& painter) {
      paintLikertFigure(painter, section, family);
    }));
  }
  if (!section.results.votes.empty()) {
    section.figures.votes = asSvg(
        voteFigureSize(section), [&](QPainter& painter) { paintVoteFigure(painter, section); });
  }
  for (const auto& device : section.protocol.devices) {
    const bool wasFelt =
        std::any_of(section.curves.begin(), section.curves.end(), [&](const FeltCurve& curve) {
          return curve.device == device.id;
        });
    if (!wasFelt) continue;
    section.figures.felt.push_back(asSvg(feltFigureSize(), [&](QPainter& painter) {
      paintFeltFigure(painter, section, device.id);
    }));
  }
}

}  // namespace study::report
