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

/// A value that a column may hold, and what it stands for.
struct Level {
  std::string value;
  std::string label;
};

/// What a column holds, for the codebook.
struct Column {
  std::string name;  ///< snake_case, with its unit
  std::string description;
  bool isFreeText = false;  ///< somebody wrote it: spreadsheets must not take it for a formula
  std::vector<Level> levels = {};  ///< in their order, where they are this column's own
};

/// A table that leaves the program: the same columns for everybody, whatever happened.
struct DataTable {
  std::string name;  ///< of the file, without its ending
  std::string description;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;
};

/// RFC 4180 in UTF-8, lines ended by LF, numbers with a point and as many digits as read back
/// exactly, whatever the desktop's language. A missing value is an empty cell. Free text that
/// begins like a formula (= + - @ or a tab) gets an apostrophe before it.
std::string asCsv(const DataTable& table);

/// A number that reads back exactly, with a point.
std::string exactly(double value);

}  // namespace study
