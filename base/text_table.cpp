#include "base/text_table.h"

#include <algorithm>
#include <cmath>

#include "base/joined.h"

namespace base {
namespace {

constexpr std::string_view kTrimmedFromCells = " \t\r\"";

}  // namespace

std::string_view withoutByteOrderMark(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

std::string_view trimmed(std::string_view text, std::string_view blanks) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);  // npos + 1 is 0: nothing remains
}

bool isBlank(std::string_view text) {
  return trimmed(text, " \t\r\n").empty();
}

std::vector<std::string_view> splitText(std::string_view text, std::string_view blanks) {
  std::vector<std::string_view> pieces;
  for (auto begin = text.find_first_not_of(blanks); begin != std::string_view::npos;) {
    const auto end = std::min(text.find_first_of(blanks, begin), text.size());
    pieces.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(blanks, end);
  }
  return pieces;
}

std::size_t characterCount(std::string_view text) {
  const auto isFirst = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
  return static_cast<std::size_t>(std::ranges::count_if(text, isFirst));
}

std::string lowerCase(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

std::optional<double> decimalNumber(std::string_view text, DecimalMark mark) {
  std::string digits(text);
  const auto comma = digits.find(',');
  const bool isCommaMark = mark == DecimalMark::PointOrComma && comma != std::string::npos &&
                           digits.find('.') == std::string::npos;
  if (isCommaMark) digits[comma] = '.';
  if (digits.starts_with('+') && !digits.starts_with("+-")) digits.erase(0, 1);

  const auto number = numberFrom<double>(digits);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::vector<TextLine> linesOf(std::string_view text) {
  std::vector<TextLine> lines;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const auto end = text.find('\n');
    const auto line = text.substr(0, end);
    if (!trimmed(line, kTrimmedFromCells).empty()) lines.push_back({line, number});
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

char separatorOf(std::string_view line) {
  for (const char separator : {'\t', ';', ','}) {
    if (line.find(separator) != std::string_view::npos) return separator;
  }
  return ',';
}

std::vector<std::string> cellsOf(std::string_view line, char separator) {
  std::vector<std::string> cells;
  if (separator == ' ') {
    for (const auto piece : splitText(line, " \t\r")) {
      cells.emplace_back(trimmed(piece, kTrimmedFromCells));
    }
    return cells;
  }
  while (true) {
    const auto end = line.find(separator);
    cells.emplace_back(trimmed(line.substr(0, end), kTrimmedFromCells));
    if (end == std::string_view::npos) return cells;
    line.remove_prefix(end + 1);
  }
}

std::optional<double> numberIn(std::string_view cell, char separator) {
  return decimalNumber(cell, separator == ',' ? DecimalMark::Point : DecimalMark::PointOrComma);
}

ColumnHeading columnHeadingOf(std::string_view cell) {
  const auto open = cell.find_first_of("[(");
  if (open != std::string_view::npos) {
    const auto close = cell.find_first_of("])", open);
    return {
        std::string(trimmed(cell.substr(0, open), kTrimmedFromCells)),
        std::string(trimmed(cell.substr(open + 1, close - open - 1), kTrimmedFromCells))};
  }
  const auto underscore = cell.rfind('_');
  if (underscore == std::string_view::npos) return {std::string(cell), ""};
  return {std::string(cell.substr(0, underscore)), std::string(cell.substr(underscore + 1))};
}

std::string listed(const std::vector<std::string>& words) {
  return joined(words, ", ", [](const auto& word) { return "'" + word + "'"; });
}

}  // namespace base
