#pragma once

#include <QPainter>
#include <QSizeF>

#include "study/report/report_section.h"

namespace study::report {

/// Who preferred what: one bar for each cohort and round, divided by condition.
QSizeF voteFigureSize(const ReportSection& section);
void paintVoteFigure(QPainter& painter, const ReportSection& section);

}  // namespace study::report
