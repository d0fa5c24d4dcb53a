#pragma once

#include <cstddef>
#include <vector>

#include "haptics/recordings/cut_landmarks.h"
#include "haptics/recordings/recording.h"
#include "haptics/recordings/row_range.h"
#include "haptics/recordings/trace.h"

namespace haptics::recordings {

/// Once closed and opened again: what may be a cut.
///
/// Found on the unfiltered travel, with hysteresis: the tool is closed as soon as the travel is
/// above 7, and open again as soon as it is below 4. The closure begins at the last row with a
/// travel of at most 4 before that, or the first row of the recording (after another closure, the
/// row that ended it), and ends at the first row below 4, or the last row of the recording.
struct Closure {
  RowRange rows{};
  double start = 0.0;             ///< of its first row, by the recorder's clock [s]
  double duration = 0.0;          ///< [s]
  double peakForce = 0.0;         ///< [N]
  std::size_t saturatedRows = 0;  ///< with the force sensor at its end: peakForce is a lower bound
  bool isComplete = false;        ///< neither begins nor ends with the recording; at most 4 s

  /// The closing hand: from the smallest filtered travel since the closure before (the last such
  /// row; a slow hand has tissue in the jaw long before the travel is 4) to the largest within.
  RowRange closing{};

  /// The opening hand: from there to the smallest filtered travel before the next closure.
  RowRange opening{};

  /// On filtered travel, from the end of the closure before on.
  CutLandmarks landmarks{};

  bool isSaturated() const noexcept { return saturatedRows > 0; }
};

inline constexpr double kClosedAbove = 7.0;     ///< [travel units]
inline constexpr double kOpenBelow = 4.0;       ///< [travel units]
inline constexpr double kLongestClosure = 4.0;  ///< of a complete one [s]

/// All closures, in the order of time.
///
/// @param trace  of the same recording.
std::vector<Closure> closuresOf(const Recording& recording, const Trace& trace);

}  // namespace haptics::recordings
