#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "haptics/recordings/recording.h"
#include "haptics/recordings/travel_filter.h"

namespace study::app {

/// A recording, and how its readings become forces and its travel smooth, as they were typed.
struct RecordingInputs {
  std::string file;
  std::string columns;      ///< a columns file; empty: the punch recorder's five columns
  std::string calibration;  ///< a name or a file; empty: the recording's own
  std::string filter = "authors-fir";
  std::optional<double> cutoff;  ///< [Hz]

  /// Adds the arguments and options to @p verb; this outlives it.
  void addTo(CLI::App& verb);

  /// The filter that was chosen. @throws UserError  where a cut-off has no filter to go with.
  haptics::recordings::TravelFilter travelFilter() const;
};

/// A recording as a file holds it, with the calibration that goes with it.
struct ReadRecording {
  haptics::recordings::Recording recording;
  haptics::recordings::ForceCalibration calibration;
};

/// @throws UserError  where a columns file, a calibration file or the recording is wrong.
ReadRecording readFrom(const RecordingInputs& inputs);

}  // namespace study::app
