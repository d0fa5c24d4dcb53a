#include <stdexcept>

#include "study/app/paint_figures.h"
#include "study/report/consent_copy.h"

namespace study::app {

void paintFigures(std::vector<report::ReportSection>& /*sections*/) {}

void paintFigures(report::Document& /*document*/) {}

std::string pdfOf(
    const std::string& /*html*/, const std::string& /*title*/, report::Paper /*paper*/) {
  throw std::runtime_error(
      "This palpate was built without Qt and makes no PDF. Write a page (.html), and print it from "
      "a browser.");
}

std::string htmlOf(const std::string& text) {
  return report::plainTextAsHtml(text);
}

int writeFigures(
    report::ReportSection& /*section*/,
    const std::filesystem::path& /*folder*/,
    const report::FigureFormat& /*format*/) {
  return 0;
}

}  // namespace study::app
