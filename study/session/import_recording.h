#pragma once

#include <string>

#include "haptics/recordings/cut_import.h"

namespace study {

/// Imports a cut under a name that a protocol can use.
haptics::recordings::ImportedCut importRecording(
    const haptics::recordings::Recording& recording, haptics::recordings::ImportOptions options);

/// The cut file, with the SHA-256 of the recording that it was made from.
std::string cutAsJsonFrom(const std::string& recording, const haptics::recordings::Cut& cut);

}  // namespace study
