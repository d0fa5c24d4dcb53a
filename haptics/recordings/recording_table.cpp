#include "haptics/recordings/recording_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

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

namespace {

constexpr double kMillisecondsPerSecond = 1000.0;
constexpr double kTravelOfAStroke = 10.0;  // [travel units]

std::string named(std::string_view source) {
  return "'" + std::string(source) + "'";
}

/// The place of a column in a row, from 0.
std::size_t placeOf(
    const TableColumn& column,
    const char* quantity,
    const std::vector<std::string>& heads,
    std::string_view source) {
  if (column.number > 0) return column.number - 1;
  for (std::size_t place = 0; place < heads.size(); ++place) {
    if (heads[place] == trimmed(column.head)) return place;
  }
  throw Error(
      named(source) + " has no column '" + column.head + "' for the " + quantity +
      ". The columns in its head are " + listed(heads) + ": correct the columns file.");
}

/// Reads rows of a table into a recording.
class TableReader {
 public:
  TableReader(
      std::string_view source, const RecordingColumns& columns, std::span<const TextLine> lines)
      : columns_(columns) {
    recording_.source = source;
    recording_.readingUnit = columns.readingUnit;
    recording_.calibration = columns.readingUnit == "N" ? newtons() : columns.calibration;
    if (columns.saturatesAt) recording_.saturation = readingOf(*columns.saturatesAt);
    requireSound();
    findColumns(lines);
  }

  Recording read(std::span<const TextLine> lines) {
    for (const TextLine& line : lines.subspan(firstRow_)) readLine(line);
    if (recording_.rows.empty()) throw Error(whyNoRow());
    return std::move(recording_);
  }

 private:
  void requireSound() const {
    if (columns_.open == columns_.closed) {
      throw Error("The travel is the same where the tool is open and where it is closed.");
    }
    if (!columns_.time && !(columns_.rate > 0.0)) {
      throw Error("The columns name neither a time nor a rate.");
    }
  }

  void findColumns(std::span<const TextLine> lines) {
    if (lines.empty()) throw Error(named(recording_.source) + " has no rows: record it again.");
    separator_ = columns_.separator.value_or(separatorOf(lines.front().text));
    const bool hasHeads = columns_.travel.number == 0 || columns_.force.number == 0 ||
                          (columns_.time && columns_.time->number == 0);
    const auto heads = cellsOf(lines.front().text, separator_);
    firstRow_ = hasHeads ? 1 : 0;
    if (columns_.time) time_ = placeOf(*columns_.time, "time", heads, recording_.source);
    travel_ = placeOf(columns_.travel, "travel", heads, recording_.source);
    force_ = placeOf(columns_.force, "force", heads, recording_.source);
  }

  void readLine(const TextLine& line) {
    recording_.lines = line.number;
    const auto cells = cellsOf(line.text, separator_);
    std::string reason;
    const auto numberAt = [&](std::size_t place, const char* quantity) {
      const auto value =
          place < cells.size() ? numberIn(cells[place], separator_) : std::optional<double>();
      if (!value && reason.empty()) {
        reason = place < cells.size()
                     ? "the " + std::string(quantity) + " '" + cells[place] + "' is no number"
                     : "no cell for the " + std::string(quantity);
      }
      return value.value_or(0.0);
    };
    const double time = time_ ? columns_.millisecondsPerTime * numberAt(*time_, "time")
                              : kMillisecondsPerSecond / columns_.rate *
                                    static_cast<double>(recording_.rows.size());
    const double travel = travelOf(numberAt(travel_, "travel"));
    const double reading = readingOf(numberAt(force_, "force"));
    if (!reason.empty()) return refuse(line.number, std::move(reason));
    requireOrder(time, line.number);
    recording_.rows.push_back({.reading = reading, .travel = travel, .time = time});
  }

  double travelOf(double cell) const {
    return kTravelOfAStroke * (cell - columns_.open) / (columns_.closed - columns_.open);
  }

  double readingOf(double cell) const { return (cell - columns_.forceZero) * columns_.forceFactor; }

  void requireOrder(double time, std::size_t line) const {
    if (recording_.rows.empty() || time >= recording_.rows.back().time) return;
    throw Error(
        "Time runs backwards in " + named(recording_.source) + " at line " + std::to_string(line) +
        ": split the file before that line and import the parts.");
  }

  void refuse(std::size_t line, std::string reason) {
    ++recording_.refusedCount;
    if (recording_.refusedLines.size() >= Recording::kMaxRefusedLines) return;
    recording_.refusedLines.push_back({line, std::move(reason)});
  }

  std::string whyNoRow() const {
    const std::string start = "No line of " + named(recording_.source) + " is a row";
    if (recording_.refusedLines.empty()) return start + ": there is only a head.";
    const Recording::RefusedLine& first = recording_.refusedLines.front();
    return start + "; line " + std::to_string(first.number) + ": " + first.reason +
           ". Check the columns file.";
  }

  const RecordingColumns& columns_;
  Recording recording_;
  char separator_ = ',';
  std::size_t firstRow_ = 0;
  std::optional<std::size_t> time_;
  std::size_t travel_ = 0;
  std::size_t force_ = 0;
};

}  // namespace

Recording readRecordingTable(
    std::string_view text, std::string_view source, const RecordingColumns& columns) {
  requireText(text, named(source));
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::vector<TextLine> lines = linesOf(text);
  std::erase_if(lines, [&](const TextLine& line) { return line.number <= columns.skippedLines; });
  return TableReader(source, columns, lines).read(lines);
}

Recording readRecordingTableFile(
    const std::filesystem::path& path, const RecordingColumns& columns) {
  return readRecordingTable(contentOfRecording(path), path.filename().string(), columns);
}

}  // namespace haptics::recordings
