#pragma once

#include <string>

#include "questionnaires/model/instrument.h"

namespace study::app {

/// The scoring key in words: a line for each scored item, and one for each score with its formula,
/// to be compared with the publication before the study begins.
std::string keysInWords(const questionnaires::Instrument& instrument);

}  // namespace study::app
