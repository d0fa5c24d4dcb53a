#pragma once

#include <QPainter>
#include <QSizeF>

#include "study/report/report_section.h"

namespace study::report {

/// How methods were judged that came first, second …: means over participants with their 95 %
/// intervals, as if all methods were alike.
QSizeF positionFigureSize(const FamilyResult& family);
void paintPositionFigure(
    QPainter& painter, const ReportSection& section, const FamilyResult& family);

}  // namespace study::report
