#pragma once

#include "study/report/report_section.h"

namespace study::report {

/// Paints all figures of a section into it. Needs a QGuiApplication.
void paintFigures(ReportSection& section);

}  // namespace study::report
