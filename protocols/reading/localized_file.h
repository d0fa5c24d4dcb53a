#pragma once

#include <string_view>

#include "questionnaires/json/document.h"
#include "questionnaires/model/localized_text.h"

namespace protocols {

/// A text that people see, in English at least: "…" or {"en": "…", "de": "…"}. Missing or wrong is
/// a problem.
questionnaires::LocalizedText readLocalized(const questionnaires::Node& node, std::string_view key);

}  // namespace protocols
