#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace haptics::recordings {

/// A recording that cannot be read, or holds no cut of the kind that was asked for; in words for
/// the person at the desk: what, to what, what to do.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Rows of a recording, numbered from 1, both ends included. Lines that are no rows do not count.
struct RowRange {
  std::size_t first = 0;
  std::size_t last = 0;

  friend bool operator==(const RowRange&, const RowRange&) = default;
};

/// What a recorder wrote while somebody cut, row by row and unchanged, and what could not be read.
struct Recording {
  /// One loop of the recorder.
  struct Row {
    double reading = 0.0;        ///< r of the force sensor, 0…1023 counts; saturates at 1023
    double grams = 0.0;          ///< the recorder's own force, by an older cubic [g]; not used
    double potentiometer = 0.0;  ///< [counts]
    double travel = 0.0;         ///< nominally 0 (open) … 10 (closed) [travel units]
    double time = 0.0;           ///< since the recorder was switched on [ms]

    friend bool operator==(const Row&, const Row&) = default;
  };

  /// A line that was there and is no row.
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

  std::string source{};                     ///< name of the file, for messages and provenance
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

}  // namespace haptics::recordings
