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

/// Rows of a recording, numbered from 1, the last one included. Other lines do not count.
struct RowRange {
  std::size_t first = 0;
  std::size_t last = 0;

  friend bool operator==(const RowRange&, const RowRange&) = default;
};

/// Where the force sensor of the published recordings is at its end, of 10 bits [counts].
inline constexpr double kSaturatedReading = 1023.0;

/// What a recorder wrote during cuts, row by row and unchanged, and what could not be read.
struct Recording {
  /// One loop of the recorder.
  struct Row {
    double reading = 0.0;  ///< of the force sensor [readingUnit]
    double grams = 0.0;    ///< the punch recorder's own force, by an older cubic [g]; not used
    double potentiometer = 0.0;  ///< the punch recorder's [counts]; not used
    double travel = 0.0;         ///< nominally 0 (open) … 10 (closed) [travel units]
    double time = 0.0;           ///< since the recorder was switched on [ms]

    friend bool operator==(const Row&, const Row&) = default;
  };

  /// A line that is not a valid row.
  struct RefusedLine {
    std::size_t number = 0;  ///< in the file, from 1
    std::string reason{};    ///< e.g. "2 numbers instead of 5"
  };

  /// How the lines end: how many of each kind.
  struct LineEnds {
    std::size_t lf = 0;
    std::size_t crlf = 0;
    std::size_t crBackslashLf = 0;  ///< residue of an RTF export
    std::size_t backslashLf = 0;
  };

  std::string source{};                ///< name of the file, for messages and provenance
  std::string readingUnit = "counts";  ///< `counts`, `V`, `mV`, or `N` where they are forces
  std::optional<ForceCalibration> calibration{};  ///< of the recorder's sensor, where it is known
  /// The reading at which the sensor saturates: a force there is a lower bound [readingUnit].
  double saturation = std::numeric_limits<double>::infinity();
  std::vector<Row> rows{};                  ///< never empty; every number is finite
  std::size_t lines = 0;                    ///< all lines, empty ones too
  std::size_t refusedCount = 0;             ///< lines that were neither a row nor empty
  std::vector<RefusedLine> refusedLines{};  ///< the first of them, at most kMaxRefusedLines
  LineEnds lineEnds{};
  std::size_t gluedBraces = 0;  ///< rows that ended in '}'

  static constexpr std::size_t kMaxRefusedLines = 20;
};

/// How evenly a recorder wrote, by its own clock. All is zero for a single row, or if no time
/// passed.
///
/// The rate is (rows − 1)/(last − first). It is not the published 333 Hz, which is the mean step
/// rounded to whole milliseconds, inverted.
struct Sampling {
  double rate = 0.0;      ///< [Hz]
  double stepMin = 0.0;   ///< [s]
  double stepMax = 0.0;   ///< [s]
  double stepMean = 0.0;  ///< [s]
};

Sampling samplingOf(const Recording& recording);

/// A number with @p digits decimals and a decimal point, in every locale.
std::string decimal(double value, int digits);

/// No recording of a minute of cutting is larger than this [bytes].
inline constexpr std::uintmax_t kLargestRecording = 200'000'000;

/// The bytes of a recording's file.
///
/// @throws UserError  if the file is missing, is a folder or anything else but a plain file, cannot
/// be
///     read or is larger than kLargestRecording.
std::string contentOfRecording(const std::filesystem::path& path);

/// @param name  what the message calls the text. @throws UserError  if it is empty or no text.
void requireText(std::string_view text, const std::string& name);

/// Reads a recording from a file; see readRecording(). Its source is the file's name without its
/// folder.
///
/// @throws UserError  where contentOfRecording() or readRecording() does.
Recording readRecordingFile(const std::filesystem::path& path);

/// Reads a recording of the punch: five numbers per line – force reading, grams, potentiometer,
/// travel, time [ms] – between tabs or blanks, without a heading.
///
/// Lines end with LF, and what stands before it is taken off: CR, backslash (residue of an RTF
/// export), and after these closing braces. A lone CR is a blank. What remains must be five
/// numbers within the range of their column, with a decimal point; anything else that is not
/// empty is refused and counted, never guessed. That goes for a last row that was cut off, too:
/// one that lacks columns, or whose line does not end and whose time lies before the row above.
///
/// @param source  what messages and provenance call it.
/// Its calibration is publishedCalibration(), and it saturates at kSaturatedReading.
///
/// @throws UserError  if there is nothing in it, if it is no text, if no line of it is a row (a
/// file
///     of four columns lacks the raw potentiometer and is told so), or if time runs backwards.
Recording readRecording(std::string_view text, std::string_view source = "the recording");

}  // namespace haptics::recordings
