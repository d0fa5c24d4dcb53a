#pragma once

#include <string>
#include <vector>

#include "study/report/document.h"
#include "study/report/pdf_report.h"
#include "study/report/report_section.h"

namespace study::app {

/// Paints the figures if the program was built with Qt, and writes the page, as a PDF if @p path
/// ends in .pdf.
/// @throws storage::StorageError  if the file exists already or cannot be written.
void writeReport(
    std::vector<report::ReportSection>& sections,
    const std::string& path,
    report::Paper paper = report::Paper::A4);

/// Writes the page @p name.html, a CSV file for each table and an SVG file for each figure into a
/// new or empty folder.
/// @throws storage::StorageError  in words.
void writeDocument(const std::string& folder, const std::string& name, report::Document document);

}  // namespace study::app
