#pragma once

#include <string>

#include "questionnaires/model/instrument.h"

namespace study::app {

/// Which answer counts how: a line for each item that is scored, and one for each score with its
/// formula, so that a key can be compared with the publication before anybody answers.
std::string keysInWords(const questionnaires::Instrument& instrument);

}  // namespace study::app
