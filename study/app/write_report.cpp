#include "study/app/write_report.h"

#include "study/app/paint_figures.h"
#include "study/new_file.h"
#include "study/report/html_report.h"

namespace study::app {

void writeReport(std::vector<report::ReportSection>& sections, const std::string& path) {
  paintFigures(sections);
  writeNewFile(path, report::asHtml(sections));
}

}  // namespace study::app
