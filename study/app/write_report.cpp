#include "study/app/write_report.h"

#include <filesystem>

#include "study/app/paint_figures.h"
#include "study/model/new_file.h"
#include "study/report/html_report.h"

namespace study::app {

std::string reportFileContent(
    const std::string& path, std::vector<report::ReportSection>& sections, report::Paper paper) {
  paintFigures(sections);
  const auto html = report::asHtml(sections);
  const bool isPdf = std::filesystem::path(path).extension() == ".pdf";
  return isPdf ? pdfOf(html, sections.front().protocol.study.title, paper) : html;
}

void writeDocument(const std::string& folder, const std::string& name, report::Document document) {
  paintFigures(document);
  std::filesystem::create_directories(folder);
  const std::filesystem::path base(folder);
  for (const auto& part : document.parts) {
    for (const auto& table : part.tables) {
      writeNewFile((base / (name + "-" + table.name + ".csv")).string(), asCsv(table));
    }
    for (const auto& figure : part.figures) {
      if (figure.svg.empty()) continue;
      writeNewFile((base / (name + "-" + figure.name + ".svg")).string(), figure.svg);
    }
  }
  writeNewFile((base / (name + ".html")).string(), report::asHtml(document));
}

}  // namespace study::app
