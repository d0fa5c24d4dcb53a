#include "study/app/write_report.h"

#include <filesystem>

#include "study/app/paint_figures.h"
#include "study/model/new_file.h"
#include "study/report/html_report.h"

namespace study::app {

void writeReport(
    std::vector<report::ReportSection>& sections, const std::string& path, report::Paper paper) {
  paintFigures(sections);
  const auto html = report::asHtml(sections);
  const bool isPdf = std::filesystem::path(path).extension() == ".pdf";
  writeNewFile(path, isPdf ? pdfOf(html, sections.front().protocol.study.title, paper) : html);
}

}  // namespace study::app
