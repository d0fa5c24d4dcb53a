#pragma once

#include <optional>
#include <string>

#include "haptics/recordings/cut_import.h"
#include "haptics/recordings/recording_table.h"

namespace study {

/// Reads the calibration that 'palpate recording calibrate' wrote to @p file.
/// @throws UserError  that names the place of the error in the file.
haptics::recordings::ForceCalibration readCalibrationFile(const std::string& file);

/// Reads a columns file, and the calibration that it names.
/// @throws UserError  says where one of them is wrong.
haptics::recordings::RecordingColumns columnsIn(const std::string& file);

/// Reads a recording of the punch's recorder; or, with a columns file, of another laboratory. A
/// calibration file that the columns file names is in the same folder.
///
/// @param columns  path of a columns file; empty: the recorder's five columns.
/// @throws UserError  that names the place of the error in the columns file, the calibration file
///     or the recording.
haptics::recordings::Recording readRecordingWithColumns(
    const std::string& file, const std::string& columns);
/// The same with the description of a table; std::nullopt: the recorder's five columns.
haptics::recordings::Recording readRecordingWithColumns(
    const std::string& file, const std::optional<haptics::recordings::RecordingColumns>& columns);

/// Imports a cut under a name that a protocol can refer to.
haptics::recordings::ImportedCut importRecording(
    const haptics::recordings::Recording& recording, haptics::recordings::ImportOptions options);

/// From a recording of the authors of the punch paper: imports the cut that their program renders,
/// unchanged and filtered by rows as in their program. From another recording: imports the most
/// typical cut, with its slope limited for the device.
haptics::recordings::ImportedCut importPublishedCut(
    const haptics::recordings::Recording& recording);

/// The text of a shipped protocol of the punch, with the cut file @p file in place of the synthetic
/// cut, and with "recorded" in its title.
std::string withRecordedCut(std::string protocol, const std::string& file);

/// The text of the cut file, with the SHA-256 of the recording file that it was made from.
std::string cutAsJsonWithSource(const std::string& recording, const haptics::recordings::Cut& cut);

}  // namespace study
