#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "haptics/recordings/cut.h"
#include "haptics/recordings/cut_choice.h"
#include "haptics/recordings/recording.h"

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

struct ImportedCut {
  Cut cut;
  ImportReport report;
};

/// Takes a cut from a recording: calibrates, filters, chooses, makes the travel rise strictly,
/// limits the slope, and says what it did.
///
/// @throws Error  if there is no closure, or none of the number that was asked for; if none may be
///     chosen unasked; if rows lie outside the recording, or do not close; if several closures
///     share no travel.
/// @throws std::invalid_argument  if both closures and rows are asked for, a closure twice, or the
///     slope limit is not positive and finite.
ImportedCut importCut(const Recording& recording, const ImportOptions& options = {});

}  // namespace haptics::recordings
