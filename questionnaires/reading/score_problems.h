#pragma once

#include <string>

#include "questionnaires/model/instrument.h"

namespace questionnaires {

/// Adds to @p problems what is wrong with @p score, which stands at @p path ("$.scores[0]") of
/// @p instrument.
void inspectScore(
    const Instrument& instrument, const Score& score, const std::string& path, Problems& problems);

/// The same for the consistency rule of @p instrument, where it has one.
void inspectConsistency(const Instrument& instrument, Problems& problems);

}  // namespace questionnaires
