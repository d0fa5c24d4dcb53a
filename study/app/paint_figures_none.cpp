#include "study/app/paint_figures.h"

namespace study::app {

void paintFigures(std::vector<report::ReportSection>& /*sections*/) {}

}  // namespace study::app
