#pragma once

#include <QPainter>
#include <QSizeF>

#include "study/report/report_section.h"

namespace study::report {

/// Who preferred what, by cohort and round: a bar for each condition with its interval; dashed, the
/// share that each would have if nobody preferred anything.
QSizeF voteFigureSize(const ReportSection& section);
void paintVoteFigure(QPainter& painter, const ReportSection& section);

}  // namespace study::report
