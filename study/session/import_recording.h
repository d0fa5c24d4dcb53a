#pragma once

#include <string>

#include "haptics/recordings/cut_import.h"

namespace study {

/// Imports a cut under a name that a protocol can use.
haptics::recordings::ImportedCut importRecording(
    const haptics::recordings::Recording& recording, haptics::recordings::ImportOptions options);

/// Imports the cut that the authors' program renders, unchanged and filtered by rows as they did,
/// from one of their recordings; from another recording the most typical cut, with its slope
/// limited for the device.
haptics::recordings::ImportedCut importCutOfStudy(const haptics::recordings::Recording& recording);

/// A shipped protocol of the punch, as text, with the cut file @p file in place of the synthetic
/// cut; its title names the cut recorded.
std::string withRecordedCut(std::string protocol, const std::string& file);

/// The cut file, with the SHA-256 of the recording that it was made from.
std::string cutAsJsonFrom(const std::string& recording, const haptics::recordings::Cut& cut);

}  // namespace study
