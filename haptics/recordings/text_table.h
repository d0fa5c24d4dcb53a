#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The parts of a table as text that testing machines, loggers and spreadsheets agree on: one row a
// line, cells between tabs, semicolons or commas, perhaps in quotation marks.
namespace haptics::recordings {

/// A line of a file and its number there, from 1.
struct TextLine {
  std::string_view text;
  std::size_t number = 0;
};

/// The lines that hold anything but blanks.
std::vector<TextLine> linesOf(std::string_view text);

/// ASCII letters in lower case; all other bytes as they are.
std::string lowerCase(std::string_view text);

/// Without blanks, carriage returns and quotation marks at both ends.
std::string trimmed(std::string_view text);

/// The cells of a line, trimmed. With a blank as separator, runs of blanks and tabs count as one.
std::vector<std::string> cellsOf(std::string_view line, char separator);

/// The first of tab, semicolon and comma that the line contains; a comma where it has none.
char separatorOf(std::string_view line);

/// The finite number in a cell, with a decimal point, or a decimal comma where commas do not
/// separate. Nothing where the cell holds anything else.
std::optional<double> numberIn(std::string cell, char separator);

/// "Weg [mm]" is a name and a unit; so are "force_n" and "Kraft (kN)". In lower case.
struct ColumnHead {
  std::string name;
  std::string unit;  ///< empty where none is given
};

ColumnHead headOf(const std::string& cell);

/// The words in quotation marks, separated by commas.
std::string listed(const std::vector<std::string>& words);

}  // namespace haptics::recordings
