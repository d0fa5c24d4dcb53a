#pragma once

#include <cstddef>
#include <vector>

#include "haptics/recordings/closure.h"
#include "haptics/recordings/recording.h"
#include "haptics/recordings/sampling.h"
#include "haptics/recordings/trace.h"

namespace haptics::recordings {

/// What somebody should know of a recording before a cut is taken from it.
struct RecordingSurvey {
  std::size_t rows = 0;
  Sampling sampling{};
  std::size_t saturatedRows = 0;  ///< force sensor at its end: clipped peaks, not plateaus
  std::size_t uncalibratedRows =
      0;                            ///< from kUncalibratedReading on, the saturated ones among them
  double minForce = 0.0;            ///< a bias, if the hand ever let go [N]
  double maxForce = 0.0;            ///< [N]
  double minTravel = 0.0;           ///< as recorded [travel units]
  double maxTravel = 0.0;           ///< as recorded [travel units]
  std::size_t distinctTravels = 0;  ///< as recorded: how coarse the potentiometer is
  std::size_t refusedLines = 0;
  std::vector<Closure> closures{};
};

/// @param trace  of the same recording.
RecordingSurvey surveyOf(const Recording& recording, const Trace& trace);

}  // namespace haptics::recordings
