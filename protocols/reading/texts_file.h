#pragma once

#include <map>
#include <string>
#include <string_view>

#include "questionnaires/model/instrument.h"

namespace protocols {

/// The protocol in @p json with @p texts as its "texts"; without that key if there are none.
/// Nothing else of the file changes, neither its lines nor its spaces.
/// @pre @p json is a JSON object without faults: a protocol that could be read.
std::string withTexts(
    std::string_view json, const std::map<std::string, questionnaires::LocalizedText>& texts);

}  // namespace protocols
