#pragma once

#include <filesystem>

#include "study/report/figures/figure_format.h"
#include "study/report/report_section.h"

namespace study::report {

/// Paints the figures of a section in a format and writes each into a folder as SVG, PDF and PNG
/// (300 dpi). Needs a QGuiApplication.
/// @return the number of figures.
/// @throws storage::StorageError  if a file exists already or cannot be written.
int writeFigures(
    ReportSection& section, const std::filesystem::path& folder, const FigureFormat& format);

}  // namespace study::report
