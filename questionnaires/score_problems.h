#pragma once

#include <string>

#include "questionnaires/instrument.h"

namespace questionnaires {

/// Adds to @p problems what is wrong with @p score, which stands at @p path ("$.scores[0]") of
/// @p instrument.
void inspectScore(
    const Instrument& instrument, const Score& score, const std::string& path, Problems& problems);

}  // namespace questionnaires
