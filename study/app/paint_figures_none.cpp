#include <stdexcept>

#include "study/app/paint_figures.h"

namespace study::app {

void paintFigures(std::vector<report::ReportSection>& /*sections*/) {}

void paintFigures(report::Document& /*document*/) {}

std::string pdfOf(const std::string& /*html*/, const std::string& /*title*/) {
  throw std::runtime_error(
      "This palpate was built without Qt and makes no PDF. Write a page (.html), and print it from "
      "a browser.");
}

int writeFigures(
    const report::ReportSection& /*section*/, const std::filesystem::path& /*folder*/) {
  return 0;
}

}  // namespace study::app
