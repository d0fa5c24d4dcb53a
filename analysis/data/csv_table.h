#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace analysis {

/// An analyst's table cannot be used; what() says what is wrong, where, and how to correct it.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;

  /// Everything that was found, one problem a line: the first ten, and how many more there are.
  explicit Error(const std::vector<std::string>& problems);
};

/// How a table writes the point of a decimal number.
enum class DecimalMark {
  Point,         ///< 4.5
  PointOrComma,  ///< 4.5 or 4,5; never both in one number
};

/// The double nearest to a decimal number, in every locale; std::nullopt for other text, for
/// infinities and for numbers beyond the range of a double.
std::optional<double> decimalNumber(std::string_view text, DecimalMark mark = DecimalMark::Point);

/// One row of a table, and the line of the file that it begins on: the header is line 1.
struct CsvRow {
  std::size_t line = 0;
  std::vector<std::string> cells;
};

/// A table as text: every row has as many cells as there are columns.
struct CsvTable {
  char separator = ',';
  std::vector<std::string> columns;
  std::vector<CsvRow> rows;

  /// Where a column is.
  /// @throws Error  if it is not there, naming those that are and the nearest; or if it is there
  ///     twice.
  std::size_t columnIndex(std::string_view name) const;
};

/// Reads comma-separated values (RFC 4180) as spreadsheets and people write them: with quotation
/// marks, any line ends, a byte order mark; rows without any text are skipped, and so are spaces
/// around a cell that has no quotation marks.
///
/// The separator is the one that the header has most of: comma, semicolon or tab.
///
/// @throws Error  for a file without a header, in UTF-16, with a quotation mark that is never
///     closed or closed too early, or with rows of too few or too many cells: all of these at once.
CsvTable readCsv(std::string_view text);

}  // namespace analysis
