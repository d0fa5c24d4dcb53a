#pragma once

#include "questionnaires/json/document.h"
#include "questionnaires/model/instrument.h"
#include "questionnaires/reading/text_reader.h"

namespace questionnaires {

/// The scale that @p node describes. Where only the points are labelled, the first and the last of
/// their labels are those of the ends.
Scale readScale(const Node& node, const TextReader& texts);

/// A scale that is none, in the place of one that could not be read.
Scale standInScale(const TextReader& texts);

}  // namespace questionnaires
