#pragma once

#include <string>

#include "study/report/document.h"

namespace study::app {

/// Writes the page @p name.html, a CSV file for each table and an SVG file for each figure into a
/// new or empty folder.
/// @throws storage::StorageError  in words.
void writeDocument(const std::string& folder, const std::string& name, report::Document document);

}  // namespace study::app
