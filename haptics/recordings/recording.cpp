#include "haptics/recordings/recording.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/text_table.h"

namespace haptics::recordings {

Sampling samplingOf(const Recording& recording) {
  constexpr double kSecondsPerMillisecond = 1e-3;
  const std::vector<Recording::Row>& rows = recording.rows;
  if (rows.size() < 2 || !(rows.back().time > rows.front().time)) return {};

  double least = rows[1].time - rows[0].time;
  double most = least;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double step = rows[i].time - rows[i - 1].time;
    least = std::min(least, step);
    most = std::max(most, step);
  }
  const double duration = (rows.back().time - rows.front().time) * kSecondsPerMillisecond;
  const auto steps = static_cast<double>(rows.size() - 1);
  return {
      .rate = steps / duration,
      .stepMin = least * kSecondsPerMillisecond,
      .stepMax = most * kSecondsPerMillisecond};
}

std::string decimal(double value, int digits) {
  std::array<char, 64> text{};
  const auto [end, error] = std::to_chars(
      text.data(), text.data() + text.size(), value, std::chars_format::fixed, digits);
  return error == std::errc{} ? std::string(text.data(), end) : "a very large number";
}

namespace {

namespace fs = std::filesystem;

void requirePlainFile(const fs::path& path) {
  const std::string name = "'" + path.string() + "'";
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    throw base::UserError("There is no recording " + name + ": check the name and the folder.");
  }
  if (error)
    throw base::UserError("The recording " + name + " cannot be reached: " + error.message() + ".");
  if (fs::is_directory(status)) {
    throw base::UserError(name + " is a folder: name one recording in it, a .txt file.");
  }
  if (!fs::is_regular_file(status)) {
    throw base::UserError(name + " is no plain file: copy the recording into one first.");
  }
}

void requireModestSize(const fs::path& path) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  if (error || size <= kLargestRecording) return;
  throw base::UserError(
      "'" + path.string() + "' is larger than 200 MB (" + std::to_string(size / 1'000'000) +
      " MB): a recording of the punch has about 1 MB a minute; check that it is one.");
}

}  // namespace

std::string contentOfRecording(const fs::path& path) {
  requirePlainFile(path);
  requireModestSize(path);
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    throw base::UserError("'" + path.string() + "' cannot be opened: check that you may read it.");
  }
  std::error_code error;
  std::string text(static_cast<std::size_t>(fs::file_size(path, error)), '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (error || stream.bad()) {
    throw base::UserError(
        "'" + path.string() + "' could not be read to its end: copy it and try again.");
  }
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

Recording readRecordingFile(const fs::path& path) {
  return readRecording(contentOfRecording(path), path.filename().string());
}

namespace {

constexpr std::string_view kBlanks = " \t\r\v\f";
constexpr std::size_t kColumns = 5;
constexpr std::size_t kLongestQuote = 20;

/// The name and the range of a column.
struct Column {
  std::string_view name;
  double lowest;
  double highest;
  std::string_view range;
};

constexpr std::array<Column, kColumns> kRowColumns{{
    {"force reading", 0.0, 1023.0, "0 to 1023"},
    {"force in grams", -1e6, 1e6, "-1000000 to 1000000"},
    {"potentiometer", 0.0, 65535.0, "0 to 65535"},
    {"travel", -1000.0, 1000.0, "-1000 to 1000"},
    {"time", 0.0, 1e12, "0 to 1e12 ms"},
}};

/// A piece of the file, shortened and without control characters, for a message.
std::string quoted(std::string_view piece) {
  std::string shown = "'";
  for (const char c : piece.substr(0, kLongestQuote)) shown += c >= ' ' && c <= '~' ? c : '~';
  return shown + (piece.size() > kLongestQuote ? "…'" : "'");
}

/// A line without '\r', '\\' and '}' at its end.
std::string_view trimmedLineOf(std::string_view line) {
  const auto withoutTail = [](std::string_view text, std::string_view tail) {
    return text.substr(0, text.find_last_not_of(tail) + 1);  // npos + 1 is 0: nothing remains
  };
  return withoutTail(withoutTail(line, "\r\\"), "}");
}

/// The result of reading a line: a row, or the reason why it is none.
struct ReadLine {
  std::optional<Recording::Row> row;
  std::string reason;
};

ReadLine readLine(std::span<const std::string_view> fields) {
  std::array<double, kColumns> values{};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::optional<double> value = base::decimalNumber(fields[i]);
    if (!value) return {{}, quoted(fields[i]) + " is no number"};
    if (i >= kColumns) continue;
    if (*value < kRowColumns[i].lowest || *value > kRowColumns[i].highest) {
      const std::string name(kRowColumns[i].name);
      return {
          {}, name + " " + quoted(fields[i]) + " is outside " + std::string(kRowColumns[i].range)};
    }
    values[i] = *value;
  }
  if (fields.size() != kColumns) {
    const std::string count = std::to_string(fields.size());
    return {{}, count + (fields.size() == 1 ? " number instead of 5" : " numbers instead of 5")};
  }
  return {Recording::Row{values[0], values[1], values[2], values[3], values[4]}, {}};
}

/// Builds a recording line by line.
class Reader {
 public:
  explicit Reader(std::string_view source) {
    recording_.source = source;
    recording_.calibration = publishedCalibration();
    recording_.saturation = kSaturatedReading;
  }

  void read(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = text.find('\n');
      const bool isWhole = end != std::string_view::npos;
      const std::string_view line = text.substr(0, end);
      ++recording_.lines;
      readLineOf(line, isWhole);
      text.remove_prefix(isWhole ? end + 1 : text.size());
    }
  }

  Recording result() {
    if (recording_.rows.empty()) throw base::UserError(whyNoRow());
    return std::move(recording_);
  }

 private:
  void readLineOf(std::string_view line, bool isWhole) {
    const std::vector<std::string_view> fields = base::splitText(trimmedLineOf(line), kBlanks);
    if (fields.empty()) return;
    const ReadLine read = readLine(fields);
    if (!read.row) {
      refuse(read.reason, fields.size() == kColumns - 1);
    } else if (isInTimeOrder(*read.row, isWhole)) {
      recording_.rows.push_back(*read.row);
    }
  }

  bool isInTimeOrder(const Recording::Row& row, bool isWhole) {
    if (recording_.rows.empty() || row.time >= recording_.rows.back().time) return true;
    if (isWhole) {
      throw base::UserError(
          "Time runs backwards in '" + recording_.source + "' at line " +
          std::to_string(recording_.lines) +
          ": two recordings in one file? Split it before that line and import the parts.");
    }
    refuse("time lies before that of the row above: the row is cut off", false);
    return false;
  }

  void refuse(std::string reason, bool isOneShort) {
    ++recording_.refusedCount;
    fourColumns_ += isOneShort ? 1 : 0;
    if (recording_.refusedLines.size() >= Recording::kMaxRefusedLines) return;
    recording_.refusedLines.push_back({recording_.lines, std::move(reason)});
  }

  std::string whyNoRow() const {
    const std::string name = "'" + recording_.source + "'";
    if (recording_.refusedCount == 0) return name + " has only empty lines: record it again.";
    if (2 * fourColumns_ > recording_.refusedCount) {
      return name +
             " has four columns: the raw potentiometer (column 3) is missing. The recorder sketch "
             "in the authors' repository prints it so; record with a version that prints five.";
    }
    const Recording::RefusedLine& first = recording_.refusedLines.front();
    return "No line of " + name +
           " is a row of five numbers (force reading, grams, potentiometer, travel, time in ms); "
           "line " +
           std::to_string(first.number) + ": " + first.reason +
           ". Only the punch's recorder writes such rows: for any other table, give a columns file "
           "that says which column is the time, the travel and the force (docs/protocol-format.md, "
           "\"Columns files\"; --columns on the command line).";
  }

  Recording recording_;
  std::size_t fourColumns_ = 0;
};

}  // namespace

void requireText(std::string_view text, const std::string& name) {
  if (text.empty()) throw base::UserError(name + " is empty: copy or record it again.");
  const std::size_t zero = text.find('\0');
  if (zero == std::string_view::npos) return;
  throw base::UserError(
      name + " is no text (byte " + std::to_string(zero + 1) +
      " is zero): choose the recorder's .txt file, saved as plain text and not as UTF-16.");
}

Recording readRecording(std::string_view text, std::string_view source) {
  requireText(text, "'" + std::string(source) + "'");
  Reader reader(source);
  reader.read(base::withoutByteOrderMark(text));
  return reader.result();
}

}  // namespace haptics::recordings
