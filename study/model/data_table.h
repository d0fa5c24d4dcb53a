#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace study {

/// One cell of an exported table. Nothing is a missing value, never a zero.
using Cell = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

/// A value where there is one.
template <typename T>
Cell cellOf(const std::optional<T>& value) {
  return value ? Cell(*value) : Cell();
}

/// What stands above a column.
struct Heading {
  std::string name;         ///< in a file: snake_case, with its unit
  std::string description;  ///< on paper and in a terminal
  bool isFreeText = false;  ///< somebody wrote it: spreadsheets must not take it for a formula
};

/// A table of a benchmark or a measurement, for a file, a page or a terminal. Tables of a study
/// that leave the program are made of columns that say more: study/export/column.h.
struct DataTable {
  std::string name;  ///< of the file, without its ending
  std::string description;
  std::vector<Heading> columns;
  std::vector<std::vector<Cell>> rows;
};

/// RFC 4180 in UTF-8, lines ended by LF, numbers with a point and as many digits as read back
/// exactly, in every locale. A missing value is an empty cell. Free text that begins like a formula
/// (= + - @ or a tab) gets an apostrophe before it.
std::string asCsv(const DataTable& table);

/// One cell of such a file.
std::string csvCell(const Cell& cell, bool isFreeText = false);

/// A number that reads back exactly, with a point.
std::string exactly(double value);

}  // namespace study
