#include "haptics/recordings/text_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace haptics::recordings {

std::vector<TextLine> linesOf(std::string_view text) {
  std::vector<TextLine> lines;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const auto end = text.find('\n');
    const auto line = text.substr(0, end);
    if (!trimmed(line).empty()) lines.push_back({line, number});
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

std::string lowerCase(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

std::string trimmed(std::string_view text) {
  const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '"'; };
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  return std::string(text);
}

namespace {

std::vector<std::string> cellsBetweenBlanks(std::string_view line) {
  constexpr std::string_view kBetweenCells = " \t\r";
  std::vector<std::string> cells;
  for (auto begin = line.find_first_not_of(kBetweenCells); begin != std::string_view::npos;) {
    const auto end = std::min(line.find_first_of(kBetweenCells, begin), line.size());
    cells.push_back(trimmed(line.substr(begin, end - begin)));
    begin = line.find_first_not_of(kBetweenCells, end);
  }
  return cells;
}

}  // namespace

std::vector<std::string> cellsOf(std::string_view line, char separator) {
  if (separator == ' ') return cellsBetweenBlanks(line);
  std::vector<std::string> cells;
  while (true) {
    const auto end = line.find(separator);
    cells.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return cells;
    line.remove_prefix(end + 1);
  }
}

char separatorOf(std::string_view line) {
  for (const char separator : {'\t', ';', ','}) {
    if (line.find(separator) != std::string_view::npos) return separator;
  }
  return ',';
}

std::optional<double> numberIn(std::string cell, char separator) {
  if (separator != ',') std::replace(cell.begin(), cell.end(), ',', '.');
  const std::string_view digits = std::string_view(cell).substr(cell.starts_with('+') ? 1 : 0);
  double value = 0.0;
  const char* const end = digits.data() + digits.size();
  const auto read = std::from_chars(digits.data(), end, value);
  const bool isNumber = read.ec == std::errc() && read.ptr == end && std::isfinite(value);
  return isNumber ? std::optional(value) : std::nullopt;
}

ColumnHead headOf(const std::string& cell) {
  const std::string text = lowerCase(cell);
  const auto open = text.find_first_of("[(");
  if (open != std::string::npos) {
    const auto close = text.find_first_of("])", open);
    return {trimmed(text.substr(0, open)), trimmed(text.substr(open + 1, close - open - 1))};
  }
  const auto underscore = text.rfind('_');
  if (underscore == std::string::npos) return {text, ""};
  return {text.substr(0, underscore), text.substr(underscore + 1)};
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + ("'" + word + "'");
  return text;
}

}  // namespace haptics::recordings
