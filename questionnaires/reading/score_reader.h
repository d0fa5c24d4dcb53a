#pragma once

#include <cstddef>

#include "questionnaires/json/document.h"
#include "questionnaires/model/instrument.h"
#include "questionnaires/reading/text_reader.h"

namespace questionnaires {

/// The score that @p node describes, the one with number @p index.
Score readScore(const Node& node, const TextReader& texts, std::size_t index);

/// The rule that @p node describes; what cannot be read of it is a problem, and left as it is.
ConsistencyRule readConsistencyRule(const Node& node);

}  // namespace questionnaires
