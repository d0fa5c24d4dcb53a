#pragma once

#include <string>

#include "study/results/apa_text.h"
#include "study/results/results.h"

namespace study {

/// The tables of a study for a terminal: means and preferences in the shape of the punch paper's
/// Tables 2 and 4, comparisons as @p profile has them, and what a reader has to know about them.
std::string resultsAsText(Study& study, const Results& results, Profile profile);

}  // namespace study
