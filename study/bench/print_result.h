#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/model/data_table.h"
#include "study/report/document.h"

namespace CLI {
class App;
}

namespace study::bench {

/// Adds --out, the folder of printAndWrite() for @p contents and a page.
void addOutFolder(
    CLI::App& command,
    std::string& folder,
    const std::string& contents = "tables (CSV), figures (SVG)");

/// Prints those tables of a result that have a description, as plain text. If @p folder is not
/// empty, also writes all tables as CSV files, figures as SVG files, and the page NAME.html, which
/// describes the computer.
/// @throws storage::StorageError  if a file exists already or cannot be written.
void printAndWrite(const std::string& folder, const std::string& name, report::Document document);

/// The cell for a measured number: empty for std::nullopt, "no number" if it is infinite or NaN.
Cell numberCell(const std::optional<double>& value);

/// The value below which the share @p q of @p values lies; @p q from 0 to below 1.
double quantile(std::vector<double> values, double q);

/// A table with aligned columns; numbers have four significant digits. Ends with a line feed.
std::string asPlainText(const DataTable& table);

}  // namespace study::bench
