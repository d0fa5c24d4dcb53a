#pragma once

#include <string>

#include "study/model/data_table.h"
#include "study/report/document.h"

namespace study::bench {

/// Prints the tables of a result that have a description, as plain text. Where a folder is named,
/// all of them are also written there as CSV files, figures as SVG files, and everything as the
/// page NAME.html, which says what computer it was measured on.
/// @throws storage::StorageError  if a file is there already or cannot be written.
void present(const std::string& folder, const std::string& name, report::Document document);

/// Columns aligned, numbers to four digits. Ends with a line feed.
std::string asPlainText(const DataTable& table);

}  // namespace study::bench
