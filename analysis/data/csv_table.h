#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/text_table.h"
#include "base/user_error.h"

namespace analysis {

/// Everything that was found, one problem a line: the first ten, and how many more there are.
base::UserError errorOf(const std::vector<std::string>& problems);

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
  /// @throws UserError  if it is not there, naming those that are and the nearest; or if it is
  /// there
  ///     twice.
  std::size_t columnIndex(std::string_view name) const;
};

/// Reads comma-separated values (RFC 4180) as spreadsheets and people write them: with quotation
/// marks, any line ends, a byte order mark; rows without any text are skipped, and so are spaces
/// around a cell that has no quotation marks.
///
/// The separator is the one that the header has most of: comma, semicolon or tab.
///
/// @throws UserError  for a file without a header, in UTF-16, with a quotation mark that is never
///     closed or closed too early, or with rows of too few or too many cells: all of these at once.
CsvTable readCsv(std::string_view text);

/// Which of some names a person most probably meant: the one that takes the fewest letters to
/// insert, delete or replace (Levenshtein 1966), without regard to case. The first of several.
///
/// @param names  at least one.
std::string nearestName(std::string_view meant, std::span<const std::string> names);

/// 'I', 'F' and 'K'; of more than eight, the first eight.
std::string enumerated(std::span<const std::string> names);

}  // namespace analysis
