#pragma once

#include <QPainter>
#include <QSizeF>

#include "study/report/report_section.h"

namespace study::report {

/// What every participant thought of every method: a dot each, equal ones on top of each other;
/// above them their density, between them the middle half and the median; a diamond is the mean.
/// After Allen et al. 2021 (raincloud plots).
QSizeF raincloudFigureSize(const FamilyResult& family);
void paintRaincloudFigure(
    QPainter& painter, const ReportSection& section, const FamilyResult& family);

}  // namespace study::report
