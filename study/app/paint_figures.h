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

/// Converts an HTML page from html_report.h or document.h to PDF. @throws std::runtime_error  if
/// the program was built without Qt.
std::string pdfOf(
    const std::string& html, const std::string& title, report::Paper paper = report::Paper::A4);

/// Converts a text of an instrument from Markdown to HTML; without Qt the text is returned with its
/// markup.
std::string htmlOf(const std::string& text);

/// Paints the figures of a section and writes each to a folder as SVG, PDF and PNG (300 dpi).
/// @param format  size and font of the figures
/// @return the number of figures; 0 without Qt.
/// @throws storage::StorageError  if a file exists already or cannot be written.
int writeFigures(
    report::ReportSection& section,
    const std::filesystem::path& folder,
    const report::FigureFormat& format);

}  // namespace study::app
