#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "haptics/recordings/recording_survey.h"
#include "haptics/recordings/row_range.h"

namespace haptics::recordings {

/// What was in a recording, what was taken from it and why, and what was changed.
struct ImportReport {
  RecordingSurvey survey{};
  std::vector<std::size_t> closures{};  ///< chosen, from 1; empty if rows were
  std::vector<RowRange> rows{};         ///< that went into the curve
  std::string reason{};                 ///< why these, in a sentence
  std::size_t mergedSamples = 0;        ///< so that the travel rises strictly
  double slopeBefore = 0.0;             ///< the largest, before it was limited [N/travel unit]
  double largestChange = 0.0;           ///< by limiting the slope [N]
  double largestChangeAt = 0.0;         ///< [travel units]
  std::vector<double> deviation{};      ///< of a mean: between its closures at each node [N]
  std::vector<std::string> changes{};   ///< all of it in words
};

}  // namespace haptics::recordings
