#include "haptics/recordings/recording_table.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/text_table.h"

namespace haptics::recordings {

namespace {

using base::TextLine;

constexpr double kMillisecondsPerSecond = 1000.0;
constexpr double kTravelOfAStroke = 10.0;  // [travel units]

std::string sourceName(std::string_view source) {
  return "'" + std::string(source) + "'";
}

/// Index of a column in a row, from 0.
std::size_t columnIndexOf(
    const TableColumn& column,
    const char* quantity,
    const std::vector<std::string>& heads,
    std::string_view source) {
  if (column.number > 0) return column.number - 1;
  for (std::size_t place = 0; place < heads.size(); ++place) {
    if (heads[place] == base::trimmed(column.heading, " \t\r\"")) return place;
  }
  throw base::UserError(
      sourceName(source) + " has no column '" + column.heading + "' for the " + quantity +
      ". The columns in its head are " + base::listed(heads) + ": correct the columns file.");
}

/// Builds a recording from the rows of a table.
class TableReader {
 public:
  TableReader(
      std::string_view source, const RecordingColumns& columns, std::span<const TextLine> lines)
      : columns_(columns) {
    recording_.source = source;
    recording_.readingUnit = columns.readingUnit;
    recording_.calibration = columns.readingUnit == "N" ? newtons() : columns.calibration;
    if (columns.saturatesAt) recording_.saturation = readingOf(*columns.saturatesAt);
    requireValid();
    findColumns(lines);
  }

  Recording read(std::span<const TextLine> lines) {
    for (const TextLine& line : lines.subspan(firstRow_)) readLine(line);
    if (recording_.rows.empty()) throw base::UserError(whyNoRow());
    return std::move(recording_);
  }

 private:
  void requireValid() const {
    if (columns_.open == columns_.closed) {
      throw base::UserError(
          "The travel is the same where the tool is open and where it is closed.");
    }
    if (!columns_.time && !(columns_.rate > 0.0)) {
      throw base::UserError("The columns name neither a time nor a rate.");
    }
  }

  void findColumns(std::span<const TextLine> lines) {
    if (lines.empty())
      throw base::UserError(sourceName(recording_.source) + " has no rows: record it again.");
    separator_ = columns_.separator.value_or(base::separatorOf(lines.front().text));
    const bool hasHeads = columns_.travel.number == 0 || columns_.force.number == 0 ||
                          (columns_.time && columns_.time->number == 0);
    const auto heads = base::cellsOf(lines.front().text, separator_);
    firstRow_ = hasHeads ? 1 : 0;
    if (columns_.time) time_ = columnIndexOf(*columns_.time, "time", heads, recording_.source);
    travel_ = columnIndexOf(columns_.travel, "travel", heads, recording_.source);
    force_ = columnIndexOf(columns_.force, "force", heads, recording_.source);
  }

  void readLine(const TextLine& line) {
    recording_.lines = line.number;
    const auto cells = base::cellsOf(line.text, separator_);
    std::string reason;
    const auto numberAt = [&](std::size_t place, const char* quantity) {
      const auto value =
          place < cells.size() ? base::numberIn(cells[place], separator_) : std::optional<double>();
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
    throw base::UserError(
        "Time runs backwards in " + sourceName(recording_.source) + " at line " +
        std::to_string(line) + ": split the file before that line and import the parts.");
  }

  void refuse(std::size_t line, std::string reason) {
    ++recording_.refusedCount;
    if (recording_.refusedLines.size() >= Recording::kMaxRefusedLines) return;
    recording_.refusedLines.push_back({line, std::move(reason)});
  }

  std::string whyNoRow() const {
    const std::string start = "No line of " + sourceName(recording_.source) + " is a row";
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
  requireText(text, sourceName(source));
  std::vector<TextLine> lines = base::linesOf(base::withoutByteOrderMark(text));
  std::erase_if(lines, [&](const TextLine& line) { return line.number <= columns.skippedLines; });
  return TableReader(source, columns, lines).read(lines);
}

Recording readRecordingTableFile(
    const std::filesystem::path& path, const RecordingColumns& columns) {
  return readRecordingTable(contentOfRecording(path), path.filename().string(), columns);
}

}  // namespace haptics::recordings
