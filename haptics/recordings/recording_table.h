#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/recordings/recording.h"

namespace haptics::recordings {

/// A column of a table: by its head, or by its number from 1 where the table has none.
struct TableColumn {
  std::string head{};
  std::size_t number = 0;  ///< from 1; 0: by its head
};

/// What the columns of another laboratory's recording mean: the content of a columns file.
///
/// A reading becomes (cell − forceZero) · forceFactor; a travel 10 · (cell − open)/(closed − open).
struct RecordingColumns {
  /// None: the rows are evenly spaced, `rate` a second.
  std::optional<TableColumn> time{};
  double millisecondsPerTime = 1000.0;  ///< milliseconds in one unit of the time column
  double rate = 0.0;                    ///< where there is no time column [Hz]

  TableColumn travel{};
  double open = 0.0;     ///< in the cells, where the tool is open
  double closed = 10.0;  ///< in the cells, where it is closed

  TableColumn force{};
  std::string readingUnit = "N";  ///< of the readings: `N`, or what the sensor gives
  double forceZero = 0.0;         ///< in the cells, where nothing is touched
  double forceFactor = 1.0;  ///< from cells to readings; negative where pressing reads negative
  std::optional<ForceCalibration> calibration{};  ///< of readings that are not newtons
  /// In the cells: from here on the sensor says no more.
  std::optional<double> saturatesAt{};

  std::size_t skippedLines = 0;     ///< above the heads, or above the first row
  std::optional<char> separator{};  ///< tab, semicolon, comma, blank; none: found in the first line
};

/// Reads a recording as a table that columns describe: a line of heads, if a column is named by its
/// head, and a row a line.
///
/// Numbers have a decimal point, or a decimal comma where commas do not separate. A line that is no
/// row (of units, or cut off) is refused and counted, never guessed.
///
/// @throws UserError  if a column is not there, if no line is a row, if time runs backwards, or
/// open
///     and closed are the same.
Recording readRecordingTable(
    std::string_view text, std::string_view source, const RecordingColumns& columns);

/// The same from a file. @throws UserError  and wherever readRecordingFile() does.
Recording readRecordingTableFile(
    const std::filesystem::path& path, const RecordingColumns& columns);

}  // namespace haptics::recordings
