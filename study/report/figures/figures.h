#pragma once

#include <QPainter>
#include <QSizeF>

#include "study/report/report_section.h"

namespace study::report {

/// Paints all figures of a section into it. Needs a QGuiApplication.
void paintFigures(ReportSection& section);

/// How far methods lie apart within people: mean differences with their intervals, thick at 1 − α,
/// thin at 1 − α/m; shaded, the differences that the protocol declares to be none.
QSizeF effectFigureSize(const FamilyResult& family);
void paintEffectFigure(QPainter& painter, const ReportSection& section, const FamilyResult& family);

/// Force over travel, as it was felt on one device: a line for each condition, with the middle 80
/// %.
QSizeF feltFigureSize();
void paintFeltFigure(QPainter& painter, const ReportSection& section, const std::string& device);

/// Diverging stacked bars: how often each point of the scale was chosen, condition by condition,
/// cohort by cohort, with the middle of the scale on one line.
QSizeF likertFigureSize(const FamilyResult& family);
void paintLikertFigure(QPainter& painter, const ReportSection& section, const FamilyResult& family);

/// How methods were judged that came first, second …: means over participants with their 95 %
/// intervals, as if all methods were alike.
QSizeF positionFigureSize(const FamilyResult& family);
void paintPositionFigure(
    QPainter& painter, const ReportSection& section, const FamilyResult& family);

/// What every participant thought of every method: a dot each, equal ones on top of each other;
/// above them their density, between them the middle half and the median; a diamond is the mean.
/// After Allen et al. 2021 (raincloud plots).
QSizeF raincloudFigureSize(const FamilyResult& family);
void paintRaincloudFigure(
    QPainter& painter, const ReportSection& section, const FamilyResult& family);

/// Who preferred what, by cohort and round: a bar for each condition with its interval; dashed, the
/// share that each would have if nobody preferred anything.
QSizeF voteFigureSize(const ReportSection& section);
void paintVoteFigure(QPainter& painter, const ReportSection& section);

}  // namespace study::report
