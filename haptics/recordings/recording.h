#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/user_error.h"
#include "haptics/recordings/force_calibration.h"

namespace haptics::recordings {

/// Rows first … last of a recording, counted from 1 without other lines.
struct RowRange {
  std::size_t first = 0;
  std::size_t last = 0;

  friend bool operator==(const RowRange&, const RowRange&) = default;
};

/// Reading at which the 10-bit force sensor of the published recordings saturates [counts].
inline constexpr double kSaturatedReading = 1023.0;

/// A recording of cuts: the unchanged rows, and what could not be read.
struct Recording {
  /// A sample of the recorder.
  struct Row {
    double reading = 0.0;  ///< of the force sensor [readingUnit]
    double grams = 0.0;  ///< the punch recorder's own force, by an older calibration [g]; not used
    double potentiometer = 0.0;  ///< of the punch recorder [counts]; not used
    double travel = 0.0;         ///< nominally 0 (open) … 10 (closed) [travel units]
    double time = 0.0;           ///< since the recorder was switched on [ms]

    friend bool operator==(const Row&, const Row&) = default;
  };

  /// A line that is not a valid row.
  struct RefusedLine {
    std::size_t number = 0;  ///< line number in the file, from 1
    std::string reason{};    ///< e.g. "2 numbers instead of 5"
  };

  std::string source{};                ///< file name, for messages and provenance
  std::string readingUnit = "counts";  ///< `counts`, `V`, `mV`, or `N` if the readings are forces
  std::optional<ForceCalibration> calibration{};  ///< of the recorder's sensor, if known
  /// The reading at which the sensor saturates [readingUnit]; the force computed from that reading
  /// is a lower bound.
  double saturation = std::numeric_limits<double>::infinity();
  std::vector<Row> rows{};                  ///< not empty; all numbers are finite
  std::size_t lines = 0;                    ///< all lines, empty ones too
  std::size_t refusedCount = 0;             ///< number of lines that were neither rows nor empty
  std::vector<RefusedLine> refusedLines{};  ///< the first kMaxRefusedLines of them

  static constexpr std::size_t kMaxRefusedLines = 20;
};

/// Sampling rate and steps by the recorder's clock. All are 0 for a single row, or if no time
/// passed.
///
/// The rate is (rows − 1)/(last − first). It differs from the published 333 Hz, which is the
/// inverse of the mean step rounded to whole milliseconds.
struct Sampling {
  double rate = 0.0;     ///< [Hz]
  double stepMin = 0.0;  ///< [s]
  double stepMax = 0.0;  ///< [s]
};

Sampling samplingOf(const Recording& recording);

/// A number with @p digits decimals and a decimal point, in every locale.
std::string decimal(double value, int digits);

/// Size limit of a recording's file [bytes], far above that of a minute of cutting.
inline constexpr std::uintmax_t kLargestRecording = 200'000'000;

/// Reads a recording's file into a string.
///
/// @throws UserError  if the file is missing, is not a regular file, cannot be read or is
///     larger than kLargestRecording.
std::string contentOfRecording(const std::filesystem::path& path);

/// @param name  name of the text in messages. @throws UserError if @p text is empty or binary.
void requireText(std::string_view text, const std::string& name);

/// Reads a recording from a file; see readRecording(). Its source is the file name without folder.
///
/// @throws UserError  as contentOfRecording() and readRecording().
Recording readRecordingFile(const std::filesystem::path& path);

/// Reads a recording of the punch: five numbers per line – force reading, grams, potentiometer,
/// travel, time [ms] – separated by tabs or spaces, without a header line. Its calibration is
/// publishedCalibration(), and it saturates at kSaturatedReading.
///
/// Lines end with LF; CR, backslash (residue of an RTF export) and closing braces before it are
/// removed. A lone CR counts as a space. The rest must be five numbers within the range of their
/// column, with a decimal point; other lines that are not empty are refused and counted. A
/// truncated last row is refused, too: a row that lacks columns, or a row without a line end whose
/// time is earlier than that of the row before.
///
/// @param source  name of the recording in messages and provenance.
/// @throws UserError  if the text is empty or binary, if no line is a row (with a hint for files of
///     four columns, which lack the raw potentiometer), or if time runs backwards.
Recording readRecording(std::string_view text, std::string_view source = "the recording");

}  // namespace haptics::recordings
