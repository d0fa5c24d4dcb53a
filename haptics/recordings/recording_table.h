#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "haptics/recordings/recording.h"

namespace haptics::recordings {

/// A column of a table, identified by its heading, or by its number if the table has no headings.
struct TableColumn {
  std::string heading{};
  std::size_t number = 0;  ///< from 1; 0: identified by its heading
};

/// Describes the columns of another laboratory's recording: the content of a columns file.
///
/// A reading becomes (cell − forceZero) · forceFactor; a travel 10 · (cell − open)/(closed − open).
struct RecordingColumns {
  /// std::nullopt: rows are evenly spaced, `rate` per second.
  std::optional<TableColumn> time{};
  double millisecondsPerTime = 1000.0;  ///< milliseconds per unit of the time column
  double rate = 0.0;                    ///< if there is no time column [Hz]

  TableColumn travel{};
  double open = 0.0;     ///< value of the cell when the tool is open
  double closed = 10.0;  ///< value of the cell when the tool is closed

  TableColumn force{};
  std::string readingUnit = "N";  ///< `N`, or the unit of the sensor
  double forceZero = 0.0;         ///< value of the cell without contact
  /// Reading per unit of the cell; negative if pressing lowers the value.
  double forceFactor = 1.0;
  std::optional<ForceCalibration> calibration{};  ///< for readings that are not newtons
  /// Value of the cell at which the sensor saturates.
  std::optional<double> saturatesAt{};

  std::size_t skippedLines = 0;     ///< number of lines before the header line or the first row
  std::optional<char> separator{};  ///< tab, semicolon, comma or space; std::nullopt: determined
                                    ///< from the first line
};

/// Reads a recording from a table: a header line, if a column is identified by its heading, and one
/// row per line.
///
/// Numbers have a decimal point, or a decimal comma if commas do not separate. A line that is not a
/// row (units, or truncated) is refused and counted.
///
/// @throws UserError  if the text is empty or binary, if a column is missing, if no line is a row,
///     if time runs backwards, if open and closed are the same, or if there is neither a column of
///     the time nor a rate.
Recording readRecordingTable(
    std::string_view text, std::string_view source, const RecordingColumns& columns);

/// Reads a table from a file. @throws UserError as readRecordingTable() and readRecordingFile().
Recording readRecordingTableFile(
    const std::filesystem::path& path, const RecordingColumns& columns);

}  // namespace haptics::recordings
