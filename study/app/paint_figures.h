#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/report/document.h"
#include "study/report/report_section.h"

namespace study::app {

/// Paints the figures of all sections; nothing in a program that was built without Qt.
void paintFigures(std::vector<report::ReportSection>& sections);

/// The same for the figures of a document.
void paintFigures(report::Document& document);

/// A page of ours as a PDF file's bytes.
/// @throws std::runtime_error  in a program that was built without Qt.
std::string pdfOf(const std::string& html, const std::string& title);

/// Puts every figure of a section into a folder as SVG, PDF and PNG (300 dpi).
/// @return how many figures; 0 where nobody painted them.
/// @throws storage::StorageError  if a file is there already or cannot be written.
int writeFigures(const report::ReportSection& section, const std::filesystem::path& folder);

}  // namespace study::app
