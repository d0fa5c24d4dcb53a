#pragma once

#include <QPainter>
#include <QSizeF>

#include "study/report/report_section.h"

namespace study::report {

/// Diverging stacked bars: how often each point of the scale was chosen, condition by condition,
/// cohort by cohort, with the middle of the scale on one line.
QSizeF likertFigureSize(const FamilyResult& family);
void paintLikertFigure(QPainter& painter, const ReportSection& section, const FamilyResult& family);

}  // namespace study::report
