#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "questionnaires/model/instrument.h"

namespace tests {

/// Whether the file of the library called @p name holds an instrument; the schema does not.
bool isInstrument(std::string_view name);

/// Every instrument that ships, by its id.
const std::map<std::string, questionnaires::Instrument>& shipped();

/// Whatever a participant may read of @p instrument.
std::vector<questionnaires::LocalizedText> visibleTexts(
    const questionnaires::Instrument& instrument);

}  // namespace tests
