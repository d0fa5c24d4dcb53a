#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "haptics/recordings/recording.h"
#include "haptics/recordings/travel_filter.h"

namespace study::app {

/// The options on a recording, its force calibration and the filter of its travel, as they were
/// typed.
struct RecordingInputs {
  std::string file;
  std::string columns;      ///< a columns file; empty: the punch recorder's five columns
  std::string calibration;  ///< name or file of a calibration; empty: that of the recording
  std::string filter = "authors-fir";
  std::optional<double> cutoff;  ///< [Hz]

  /// Adds the arguments and options to the command @p verb; this object must outlive it.
  void addTo(CLI::App& verb);

  /// The chosen filter. @throws UserError  if a cut-off was given for a filter that has none.
  haptics::recordings::TravelFilter travelFilter() const;
};

/// A recording from a file, and its calibration.
struct CalibratedRecording {
  haptics::recordings::Recording recording;
  haptics::recordings::ForceCalibration calibration;
};

/// @throws UserError  if a columns file, a calibration file or the recording is invalid.
CalibratedRecording readFrom(const RecordingInputs& inputs);

}  // namespace study::app
