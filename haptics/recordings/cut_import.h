#pragma once

#include "haptics/recordings/cut.h"
#include "haptics/recordings/import_options.h"
#include "haptics/recordings/import_report.h"
#include "haptics/recordings/recording.h"

namespace haptics::recordings {

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
