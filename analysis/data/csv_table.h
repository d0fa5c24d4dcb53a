#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/text_table.h"
#include "base/user_error.h"

namespace analysis {

/// An error that lists the first ten problems, one per line, and how many more there are.
base::UserError errorOf(const std::vector<std::string>& problems);

/// One row of a table, and the line of the file that it begins on: the header is line 1.
struct CsvRow {
  std::size_t line = 0;
  std::vector<std::string> cells;
};

/// A table of text cells. Every row has as many cells as there are columns.
struct CsvTable {
  char separator = ',';
  std::vector<std::string> columns;
  std::vector<CsvRow> rows;

  /// The index of a column.
  /// @throws UserError  if there is no such column (the message lists the first eight columns and
  ///     the most similar name), or if two columns have that name.
  std::size_t columnIndex(std::string_view name) const;
};

/// Reads comma-separated values (RFC 4180) as spreadsheets and people write them: with quotation
/// marks, any line ends, or a byte order mark. Skips rows without text, and spaces around cells
/// without quotation marks.
///
/// The separator is the most frequent one in the header: comma, semicolon or tab.
///
/// @throws UserError  for a file without a header, in UTF-16, with a quotation mark that is never
///     closed or closed too early, or with rows of too few or too many cells. The message lists the
///     first ten such rows.
CsvTable readCsv(std::string_view text);

/// The name in @p names of which @p meant is most probably a misspelling: the name with the
/// fewest edits between them (base::editDistance()), ignoring case; the first such name of several.
/// std::nullopt if all need more than two edits and more than a third of the word.
std::optional<std::string> nearestName(std::string_view meant, std::span<const std::string> names);

/// The names as an English list, "'I', 'F' and 'K'"; only the first eight of more than eight.
std::string enumerated(std::span<const std::string> names);

}  // namespace analysis
