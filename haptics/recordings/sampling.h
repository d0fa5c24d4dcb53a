#pragma once

#include "haptics/recordings/recording.h"

namespace haptics::recordings {

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
