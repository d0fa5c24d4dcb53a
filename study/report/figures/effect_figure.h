#pragma once

#include <QPainter>
#include <QSizeF>

#include "study/report/report_section.h"

namespace study::report {

/// How far methods lie apart within people: mean differences with their intervals, thick at 1 − α,
/// thin at 1 − α/m; shaded, the differences that the protocol declares to be none.
QSizeF effectFigureSize(const FamilyResult& family);
void paintEffectFigure(QPainter& painter, const ReportSection& section, const FamilyResult& family);

}  // namespace study::report
