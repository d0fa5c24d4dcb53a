#include "study/report/figures/figure_files.h"

#include "study/model/new_file.h"
#include "study/report/figures/figures.h"
#include "study/report/pdf_report.h"

namespace study::report {

int writeFigures(
    ReportSection& section, const std::filesystem::path& folder, const FigureFormat& format) {
  paintFigures(section, format);
  const auto figures = namedFigures(section);
  for (const auto& [name, svg] : figures) {
    const auto path = (folder / (section.protocol.study.id + "-" + name)).string();
    writeNewFile(path + ".svg", svg);
    writeNewFile(path + ".pdf", figureAsPdf(svg, format.scale()));
    writeNewFile(path + ".png", figureAsPng(svg, format.scale()));
  }
  return static_cast<int>(figures.size());
}

}  // namespace study::report
