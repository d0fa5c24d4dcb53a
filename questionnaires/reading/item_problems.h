#pragma once

#include <string>

#include "questionnaires/model/instrument.h"
#include "questionnaires/reading/text_problems.h"

namespace questionnaires {

/// Adds to @p problems what is wrong with @p item, which stands at @p path ("$.items[3]") of
/// @p instrument.
void inspectItem(
    const Instrument& instrument, const Item& item, const std::string& path, Problems& problems);

/// The same for a scale.
void inspectScale(
    const Scale& scale, const std::string& path, const TextProblems& texts, Problems& problems);

}  // namespace questionnaires
