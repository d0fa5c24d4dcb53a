#pragma once

#include <vector>

#include "study/report/document.h"
#include "study/report/report_section.h"

namespace study::app {

/// Paints the figures of all sections; nothing in a program that was built without Qt.
void paintFigures(std::vector<report::ReportSection>& sections);

/// The same for the figures of a document.
void paintFigures(report::Document& document);

}  // namespace study::app
