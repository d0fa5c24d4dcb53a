#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/report/document.h"
#include "study/report/figures/figure_format.h"
#include "study/report/pdf_report.h"
#include "study/report/report_section.h"

namespace study::app {

/// Paints the figures of all sections; does nothing if the program was built without Qt.
void paintFigures(std::vector<report::ReportSection>& sections);

/// Paints the figures of a document; does nothing if the program was built without Qt.
void paintFigures(report::Document& document);

/// A page of html_report.h or document.h as a PDF file. @throws std::runtime_error  if the program
/// was built without Qt.
std::string pdfOf(
    const std::string& html, const std::string& title, report::Paper paper = report::Paper::A4);

/// Converts a text of an instrument from Markdown to HTML; without Qt the markup is not converted.
std::string htmlOf(const std::string& text);

/// Paints the figures of a section in a format and writes each into a folder as SVG, PDF and PNG
/// (300 dpi).
/// @return the number of figures; 0 if none were painted.
/// @throws storage::StorageError  if a file exists already or cannot be written.
int writeFigures(
    report::ReportSection& section,
    const std::filesystem::path& folder,
    const report::FigureFormat& format);

}  // namespace study::app
