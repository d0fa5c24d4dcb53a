#pragma once

#include <QPainter>
#include <QSizeF>

#include "study/report/report_section.h"

namespace study::report {

/// Force over travel, as it was felt on one device: a line for each condition, with the middle 80
/// %.
QSizeF feltFigureSize();
void paintFeltFigure(QPainter& painter, const ReportSection& section, const std::string& device);

}  // namespace study::report
