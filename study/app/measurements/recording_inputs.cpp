#include "study/app/measurements/recording_inputs.h"

#include <filesystem>

#include <fmt/format.h>

#include "haptics/recordings/trace.h"
#include "study/app/command_options.h"
#include "study/model/user_error.h"
#include "study/session/import_recording.h"

namespace study::app {
namespace {

namespace recordings = haptics::recordings;

/// The built-in calibration with this name, or the calibration in a file.
recordings::ForceCalibration calibrationNamed(const std::string& name) {
  for (const auto& known :
       {recordings::publishedCalibration(), recordings::recorder2021Calibration()}) {
    if (known.name == name) return known;
  }
  if (std::filesystem::exists(name)) return readCalibrationFile(name);
  throw UserError(fmt::format(
      "There is no calibration '{}'. Name paper-eq1, recorder-2021, or a file that 'palpate "
      "recording calibrate' has written.",
      name));
}

}  // namespace

void RecordingInputs::addTo(CLI::App& verb) {
  verb.add_option(
          "FILE",
          file,
          "Recording (text) with five columns: force sensor [counts], grams (not used), "
          "potentiometer [counts], travel, time [ms]; for other columns see --columns")
      ->required();
  verb.add_option(
          "--columns",
          columns,
          "Columns file (JSON) that describes other columns of FILE (docs/protocol-format.md, "
          "Recordings)")
      ->type_name("FILE");
  verb.add_option(
      "--calibration",
      calibration,
      "Calibration to newtons: paper-eq1 (eq. 1 of the punch paper), recorder-2021 (the formula "
      "of the program that made the published recordings), or a file from 'recording calibrate "
      "--out' (default: "
      "paper-eq1 for five columns, else as in the columns file)");
  verb.add_option(
          "--filter",
          filter,
          "Low-pass filter of the travel: of the punch paper's authors, designed for the rate of "
          "FILE (authors-fir) or always for 333 Hz (authors-fir-333, as published); Butterworth; "
          "or none")
      ->check(CLI::IsMember(recordings::travelFilterNames()))
      ->capture_default_str();
  verb.add_option(
          "--cutoff",
          cutoff,
          "Cut-off frequency of butterworth-zero-phase, where the amplitude is halved [Hz] "
          "(default: 5)")
      ->check(finiteRange(1e-3, 1e5));
}

recordings::TravelFilter RecordingInputs::travelFilter() const {
  recordings::TravelFilter chosen{.kind = *recordings::travelFilterNamed(filter)};
  if (cutoff && chosen.kind != recordings::TravelFilter::Kind::ButterworthZeroPhase) {
    throw UserError(fmt::format(
        "'{}' has no cut-off to choose. Write --filter butterworth-zero-phase --cutoff {:g}.",
        filter,
        *cutoff));
  }
  if (cutoff) chosen.cutoff = *cutoff;
  return chosen;
}

CalibratedRecording readFrom(const RecordingInputs& inputs) {
  auto recording = readRecordingWithColumns(inputs.file, inputs.columns);
  if (!inputs.calibration.empty()) recording.calibration = calibrationNamed(inputs.calibration);
  auto calibration = recordings::calibrationFor(recording);
  return {std::move(recording), std::move(calibration)};
}

}  // namespace study::app
