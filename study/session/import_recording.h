#pragma once

#include <string>

#include "haptics/recordings/cut_import.h"

namespace study {

/// Reads the calibration that 'palpate recording calibrate' wrote to @p file.
/// @throws UserError  says where the file is wrong.
haptics::recordings::ForceCalibration calibrationIn(const std::string& file);

/// Reads a recording of the punch's recorder; or, with a columns file, of another laboratory. A
/// calibration file that the columns file names is in the same folder.
///
/// @param columns  path of a columns file; empty: the recorder's five columns.
/// @throws UserError  says where the columns file, the calibration file or the recording is wrong.
haptics::recordings::Recording recordingIn(const std::string& file, const std::string& columns);

/// Imports a cut under a name that a protocol can use.
haptics::recordings::ImportedCut importRecording(
    const haptics::recordings::Recording& recording, haptics::recordings::ImportOptions options);

/// Imports the cut that the authors' program renders, unchanged and filtered by rows as they did,
/// from one of their recordings; from another recording the most typical cut, with its slope
/// limited for the device.
haptics::recordings::ImportedCut importCutOfStudy(const haptics::recordings::Recording& recording);

/// The text of a shipped protocol of the punch, with the cut file @p file in place of the synthetic
/// cut; its title calls the cut recorded.
std::string withRecordedCut(std::string protocol, const std::string& file);

/// The text of the cut file, with the SHA-256 of the recording file that it was made from.
std::string cutAsJsonFrom(const std::string& recording, const haptics::recordings::Cut& cut);

}  // namespace study
