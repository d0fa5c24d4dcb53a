#pragma once

#include "haptics/recordings/cut.h"
#include "questionnaires/json/document.h"

namespace protocols {

/// Reads from a whole cut file where the cut comes from (docs/protocol-format.md, "Cut files");
/// everything that is wrong with it goes into @p problems.
haptics::recordings::Provenance readProvenance(
    const questionnaires::Value& cut, questionnaires::Problems& problems);

}  // namespace protocols
