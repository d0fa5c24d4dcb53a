#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

// Parses text tables as testing machines, loggers and spreadsheets write them: one row per line,
// cells separated by tabs, semicolons, commas or blanks, perhaps in quotation marks.
namespace base {

/// @p text without the byte order mark that some programs write at the beginning of UTF-8.
std::string_view withoutByteOrderMark(std::string_view text);

/// @p text without leading and trailing characters of @p blanks.
std::string_view trimmed(std::string_view text, std::string_view blanks = " \t");

/// Whether @p text has nothing but blanks and line breaks.
bool isBlank(std::string_view text);

/// The pieces of @p text between runs of characters of @p blanks.
std::vector<std::string_view> splitText(std::string_view text, std::string_view blanks);

/// The number of characters of a text in UTF-8: its bytes without those that continue a character.
std::size_t characterCount(std::string_view text);

/// ASCII letters in lower case; all other bytes as they are.
std::string lowerCase(std::string_view text);

/// The decimal separators that a table may use.
enum class DecimalMark {
  Point,         ///< 4.5
  PointOrComma,  ///< 4.5 or 4,5; never both in one number
};

/// The double nearest to a decimal number, in every locale; std::nullopt for other text, for
/// infinities and for numbers beyond the range of a double.
std::optional<double> decimalNumber(std::string_view text, DecimalMark mark = DecimalMark::Point);

/// The number that the whole of @p text is, in every locale; std::nullopt for other text, such as
/// one with blanks or a plus sign, and for numbers that a Number cannot hold.
template <typename Number>
std::optional<Number> numberFrom(std::string_view text) {
  Number number{};
  const auto [stopped, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool isNumber = problem == std::errc{} && stopped == text.data() + text.size();
  return isNumber ? std::optional(number) : std::nullopt;
}

/// A line of a file and its number there, from 1.
struct TextLine {
  std::string_view text;
  std::size_t number = 0;
};

/// The lines of @p text, without those that hold only blanks and quotation marks.
std::vector<TextLine> linesOf(std::string_view text);

/// The separator of a line: tab if it contains one, else semicolon if it contains one, else comma.
char separatorOf(std::string_view line);

/// The cells of a line, without blanks and quotation marks around them. With a blank as separator,
/// runs of blanks and tabs count as one.
std::vector<std::string> cellsOf(std::string_view line, char separator);

/// The finite number in a cell, with a decimal point, or with a decimal comma unless the comma
/// separates cells; std::nullopt if the cell holds anything else.
std::optional<double> numberIn(std::string_view cell, char separator);

/// The heading of a column, split into name and unit: "Weg [mm]", "force_n", "Kraft (kN)".
struct ColumnHeading {
  std::string name;
  std::string unit;  ///< empty if none is given
};

ColumnHeading columnHeadingOf(std::string_view cell);

/// The words in quotation marks, separated by commas.
std::string listed(const std::vector<std::string>& words);

}  // namespace base
