#include "tests/study/exported_rows.h"

#include <stdexcept>

#include "analysis/data/csv_table.h"

namespace tests {

std::vector<ExportedRow> rowsOf(const study::ExportedTable& table) {
  const auto csv = analysis::readCsv(study::asCsv(table));
  std::vector<ExportedRow> rows;
  for (const auto& line : csv.rows) {
    auto& row = rows.emplace_back();
    for (std::size_t i = 0; i < csv.columns.size(); ++i) row[csv.columns[i]] = line.cells[i];
  }
  return rows;
}

std::vector<ExportedRow> rowsOf(
    study::Study& study, const std::string& table, const study::ExportOptions& options) {
  for (const auto& each : exportTables(study, options)) {
    if (each.name == table) return rowsOf(each);
  }
  throw std::logic_error("no table " + table);
}

ExportedRow filledCells(ExportedRow row) {
  std::erase_if(row, [](const auto& cell) { return cell.second.empty(); });
  return row;
}

}  // namespace tests
