#pragma once

#include <string>
#include <vector>

#include "study/report/document.h"
#include "study/report/pdf_report.h"
#include "study/report/report_section.h"

namespace study::app {

/// The report as an HTML page, or as PDF if @p path ends in .pdf; with figures if the program was
/// built with Qt.
std::string reportFileContent(
    const std::string& path,
    std::vector<report::ReportSection>& sections,
    report::Paper paper = report::Paper::A4);

/// Writes the page @p name.html, each table as CSV and each figure as SVG to @p folder, which is
/// made if it is absent.
/// @throws storage::StorageError  if one of the files exists already or cannot be written.
void writeDocument(const std::string& folder, const std::string& name, report::Document document);

}  // namespace study::app
