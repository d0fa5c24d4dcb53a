#pragma once

#include <map>
#include <string>
#include <vector>

#include "study/export/export.h"

namespace tests {

/// A row of an exported table, by column name.
using ExportedRow = std::map<std::string, std::string>;

/// The rows of a table as in its CSV file.
std::vector<ExportedRow> rowsOf(const study::ExportedTable& table);

/// … of the table of that name in an export of all run modes. @throws std::logic_error  if there is
/// no such table.
std::vector<ExportedRow> rowsOf(
    study::Study& study, const std::string& table, const study::ExportOptions& options);

/// The cells of a row that have something in them.
ExportedRow filledCells(ExportedRow row);

}  // namespace tests
