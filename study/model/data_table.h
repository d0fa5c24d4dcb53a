#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace study {

/// One cell of an exported table. std::monostate is a missing value, never a zero.
using Cell = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

/// The cell of an optional value; std::monostate for std::nullopt.
template <typename T>
Cell cellOf(const std::optional<T>& value) {
  return value ? Cell(*value) : Cell();
}

/// The cell of a number; std::monostate for one that is infinite or NaN.
Cell finiteCell(double value);

/// A cell as people read it: "yes", "12", "0.1235" of four digits; "–" for a missing value.
std::string textOfCell(const Cell& cell);

/// The heading of a column.
struct Heading {
  std::string name;         ///< in a file: snake_case, with its unit; in a window: words
  std::string description;  ///< shown in reports and terminals
  bool isFreeText = false;  ///< entered by people: spreadsheets must not read it as a formula

  /// The heading of a column of words. They may begin with a title that people entered, so that
  /// spreadsheets must not read them as formulas.
  static Heading ofWords(std::string name) { return {std::move(name), {}, true}; }
};

/// A table of a benchmark or a measurement, for a file, a page or a terminal. The data of a study
/// are exported as ExportedTable, whose columns have types and units (study/export/column.h).
struct DataTable {
  std::string name;  ///< of the file, without its extension
  std::string description;
  std::vector<Heading> columns;
  std::vector<std::vector<Cell>> rows = {};
};

/// @p text, with an apostrophe before it if a spreadsheet would read it as a formula.
std::string withFormulaEscaped(const std::string& text);

/// One cell of a CSV file. Numbers have a decimal point in every locale, and enough digits to be
/// read back exactly. A missing value is an empty cell. Free text that begins like a formula (= + -
/// @, a tab or a carriage return) gets an apostrophe before it.
std::string csvCell(const Cell& cell, bool isFreeText = false);

/// The names of the columns, then the rows, each on a line that ends with LF.
/// @param table  a DataTable, or an ExportedTable (study/export/column.h)
/// @param textOf  the text of a cell, given the cell and whether it is free text
template <typename Table, typename TextOf>
std::string asLines(const Table& table, char separator, const TextOf& textOf) {
  std::string text;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (i > 0) text += separator;
    text += textOf(Cell(table.columns[i].name), true);
  }
  text += '\n';
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) text += separator;
      text += textOf(row[i], table.columns[i].isFreeText);
    }
    text += '\n';
  }
  return text;
}

/// RFC 4180 in UTF-8, but lines end with LF; csvCell() says how cells are written.
template <typename Table>
std::string asCsv(const Table& table) {
  return asLines(table, ',', csvCell);
}

/// The shortest decimal text that parses back to exactly @p value, with a decimal point in every
/// locale.
std::string exactDecimal(double value);

}  // namespace study
